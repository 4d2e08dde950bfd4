// Asks an engine's script for every medium, in every way it can be entered, at every angle.

export async function measure(engine, media, degrees, settings) {
  const { open } = await import(`./${engine}.js`);
  const run = await open();

  async function drawn(way, typed, light) {
    const rows = [];
    for (const at of degrees) {
      const pixels = await run.reflect(way, typed, light, (at * Math.PI) / 180);
      const mean = [0, 0, 0];
      for (let p = 0; p < pixels.length; p += 4) {
        for (let c = 0; c < 3; c++) mean[c] += pixels[p + c] / (pixels.length / 4);
      }
      rows.push(mean);
    }
    return rows;
  }

  const curves = [];
  for (const light of run.lights ?? ["environment", "light"]) {
    const [white, ...others] = media;
    const [whiteWay, whiteTyped] = Object.entries(run.ways(white))[0];
    await drawn(whiteWay, whiteTyped, light); // the first frame is drawn before all is loaded
    const whole = await drawn(whiteWay, whiteTyped, light);
    if (light === "environment") {
      curves.push({
        light,
        medium: white.name,
        way: whiteWay,
        typed: whiteTyped,
        reflectance: whole,
      });
    }
    // A highlight is told as a share of that of white metal, unless it is a reflectance already.
    const share = light === "light" && !run.absolute;
    for (const medium of others) {
      for (const [way, typed] of Object.entries(run.ways(medium))) {
        const rows = await drawn(way, typed, light);
        const reflectance = rows.map((row, i) => row.map((v, c) => (share ? v / whole[i][c] : v)));
        curves.push({ light, medium: medium.name, way, typed, reflectance });
      }
    }
  }
  for (const [way, typed] of settings) {
    const reflectance = await drawn(way, typed, "environment");
    curves.push({ light: "environment", medium: "settings", way, typed, reflectance });
  }
  return curves;
}
