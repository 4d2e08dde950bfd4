import assert from "node:assert/strict";
import { test } from "node:test";
import { inMicrometers } from "../../static/js/media/wavelength.js";
import { instead } from "../../static/js/numbers/meant.js";

const RULE = "N = n + i k with k >= 0; for n";

test("another sign and complex indices are told what to give", () => {
  assert.equal(instead("k_t", -3.4), `${RULE} - i k give 3.4`);
  for (const text of ["0.2+3.4j", "0.2 + 3.4 i", "(0.2+3.4*i)", "0.2 + 3.4I"])
    assert.equal(instead("n_t", text), `${RULE} + i k give n_t = 0.2 and k_t = 3.4`);
  assert.equal(instead("n_t", "0.2-3.4j"), `${RULE} - i k give n_t = 0.2 and k_t = 3.4`);
  assert.equal(instead("k_t", "3.4i"), `${RULE} + i k give k_t = 3.4`);
  for (const [name, given] of /** @type {[string, string | number][]} */ ([
    ["k_t", 101],
    ["n_t", -1],
    ["n_t", "sqrt(2"],
    ["n_i", "1+1i"],
  ]))
    assert.equal(instead(name, given), null);
});

test("a wavelength of a few nanometers may be one in micrometers", () => {
  assert.equal(inMicrometers(0.55), "in nm: did you mean 550?");
  assert.equal(inMicrometers(5.5e-7), "in nm: did you mean 550?"); // in meters
  assert.equal(instead("wavelength_nm", 0.55), "in nm: did you mean 550?");
  for (const nm of [null, 0, 10, 550]) assert.equal(inMicrometers(nm), "");
});
