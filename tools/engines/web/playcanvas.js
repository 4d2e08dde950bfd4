// PlayCanvas: StandardMaterial in its metalness workflow, an even sky in its own atlas.
import * as pc from "playcanvas";

const DISTANCE = 10;

export async function open() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 4;
  const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
  app.autoRender = false;
  app.start();
  const device = app.graphicsDevice;
  const face = () => new Float32Array([1, 1, 1, 1]);
  const sky = new pc.Texture(device, {
    cubemap: true,
    width: 1,
    height: 1,
    format: pc.PIXELFORMAT_RGBA32F,
    mipmaps: false,
    levels: [[face(), face(), face(), face(), face(), face()]],
  });
  const even = pc.EnvLighting.generateAtlas(sky);
  app.scene.ambientLight = new pc.Color(0, 0, 0);
  app.scene.exposure = 1;
  const color = new pc.Texture(device, {
    width: 4,
    height: 4,
    format: pc.PIXELFORMAT_RGBA32F,
    mipmaps: false,
  });
  const target = new pc.RenderTarget({ colorBuffer: color, depth: true });
  const plane = new pc.Entity();
  plane.addComponent("render", { type: "plane" });
  plane.setLocalScale(1000, 1, 1000);
  const camera = new pc.Entity();
  camera.addComponent("camera", {
    projection: pc.PROJECTION_ORTHOGRAPHIC,
    orthoHeight: 0.01,
    nearClip: 0.1,
    farClip: 100,
    renderTarget: target,
    clearColor: new pc.Color(0, 0, 0),
    toneMapping: pc.TONEMAP_LINEAR,
    gammaCorrection: pc.GAMMA_NONE,
  });
  const light = new pc.Entity();
  light.addComponent("light", { type: "directional", intensity: 1e-6 });
  for (const entity of [plane, camera, light]) app.root.addChild(entity);

  return {
    ways({ metal, n, F0 }) {
      const plain = { useMetalness: true, gloss: 1 };
      if (!metal) {
        return {
          refractionIndex: {
            ...plain,
            metalness: 0,
            diffuse: [0, 0, 0],
            refractionIndex: 1 / n[0],
          },
        };
      }
      return { diffuse: { ...plain, metalness: 1, diffuse: F0 } };
    },
    async reflect(_way, { diffuse, ...numbers }, under, theta) {
      const material = new pc.StandardMaterial();
      Object.assign(material, numbers);
      const encoded = new pc.Color(...diffuse).gamma(); // a color is taken as sRGB
      material.diffuse = encoded;
      material.update();
      plane.render.meshInstances[0].material = material;
      const [x, y] = [DISTANCE * Math.sin(theta), DISTANCE * Math.cos(theta)];
      camera.setPosition(x, y, 0);
      camera.lookAt(new pc.Vec3(0, 0, 0), new pc.Vec3(0, 0, 1));
      light.enabled = under === "light";
      light.setPosition(-x, y, 0);
      light.lookAt(new pc.Vec3(0, 0, 0), new pc.Vec3(0, 0, 1));
      light.rotateLocal(90, 0, 0);
      app.scene.envAtlas = under === "light" ? null : even;
      app.render();
      const pixels = await color.read(0, 0, 4, 4, { renderTarget: target, immediate: true });
      material.destroy();
      return pixels;
    },
  };
}
