/** glTF: each file is validated by Khronos' validator. */
import { readFileSync } from "node:fs";
import { validateBytes } from "gltf-validator";

const entries = JSON.parse(readFileSync(0, "utf8"));
const errors = [];
const warnings = {};
for (const { file, material, mode } of entries) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)));
  for (const { severity, code, message } of report.issues.messages) {
    if (severity === 0) errors.push(`${material} ${mode}: ${message}`);
    else warnings[code] = (warnings[code] ?? 0) + 1;
  }
}
console.log(JSON.stringify({ read: entries.length, errors, warnings }));
