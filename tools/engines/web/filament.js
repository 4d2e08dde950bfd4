// Filament: glTF files in memory, read by its own loader, drawn without post-processing.
const DISTANCE = 10;

function plane() {
  const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0].map((x) => 500 * x));
  const normals = new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
  const indices = new Uint16Array([0, 1, 2, 0, 2, 3]);
  const bytes = new Uint8Array(48 + 48 + 12);
  bytes.set(new Uint8Array(corners.buffer), 0);
  bytes.set(new Uint8Array(normals.buffer), 48);
  bytes.set(new Uint8Array(indices.buffer), 96);
  return btoa(String.fromCharCode(...bytes));
}

const PLANE = plane();

function gltf(material) {
  return {
    asset: { version: "2.0" },
    extensionsUsed: Object.keys(material.extensions ?? {}),
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [material],
    buffers: [{ byteLength: 108, uri: `data:application/octet-stream;base64,${PLANE}` }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 48 },
      { buffer: 0, byteOffset: 96, byteLength: 12 },
    ],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 4,
        type: "VEC3",
        min: [-500, -500, 0],
        max: [500, 500, 0],
      },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC3" },
      { bufferView: 2, componentType: 5123, count: 6, type: "SCALAR" },
    ],
  };
}

async function loaded() {
  const script = document.createElement("script");
  script.src = "/node_modules/filament/filament.js";
  document.head.append(script);
  await new Promise((resolve) => {
    script.onload = resolve;
  });
  // The package asks for these names of gl-matrix as globals.
  const matrix = document.createElement("script");
  matrix.src = "/node_modules/gl-matrix/gl-matrix-min.js";
  document.head.append(matrix);
  await new Promise((resolve) => {
    matrix.onload = resolve;
  });
  Object.assign(globalThis, globalThis.glMatrix ?? {});
  await new Promise((resolve) => Filament.init([], resolve));
}

export async function open() {
  await loaded();
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 4;
  document.body.append(canvas);
  const engine = Filament.Engine.create(canvas, { preserveDrawingBuffer: true, alpha: true });
  const gl = canvas.getContext("webgl2");
  gl.getExtension("EXT_color_buffer_half_float");
  gl.getExtension("EXT_color_buffer_float");
  gl.drawingBufferStorage(gl.RGBA16F, 4, 4);
  const scene = engine.createScene();
  const view = engine.createView();
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, 4, 4]);
  view.setPostProcessingEnabled(false);
  const swapChain = engine.createSwapChain();
  const renderer = engine.createRenderer();
  renderer.setClearOptions({ clearColor: [0, 0, 0, 1], clear: true });
  camera.setProjection(Filament.Camera$Projection.ORTHO, -0.01, 0.01, -0.01, 0.01, 0.1, 100);
  camera.setExposureDirect(1);
  const { Builder } = Filament.Texture;
  const sky = Builder()
    .width(1)
    .height(1)
    .levels(1)
    .sampler(Filament.Texture$Sampler.SAMPLER_CUBEMAP)
    .format(Filament.Texture$InternalFormat.RGBA16F)
    .build(engine);
  const faces = Filament.PixelBuffer(
    new Float32Array(24).fill(1),
    Filament.PixelDataFormat.RGBA,
    Filament.PixelDataType.FLOAT,
  );
  sky.setImageCube(engine, 0, faces);
  const even = Filament.IndirectLight.Builder()
    .reflections(sky)
    .irradianceSh(1, [1, 1, 1])
    .intensity(1)
    .build(engine);
  scene.setIndirectLight(even);
  const sun = Filament.EntityManager.get().create();
  Filament.LightManager.Builder(Filament.LightManager$Type.DIRECTIONAL)
    .color([1, 1, 1])
    .intensity(1e-4)
    .direction([0, 0, -1])
    .build(engine, sun);
  const suns = engine.getLightManager();
  const loader = engine.createAssetLoader();
  const specular = { KHR_materials_specular: { specularFactor: 1 } };
  const plain = { metallicFactor: 0, roughnessFactor: 0, baseColorFactor: [0, 0, 0, 1] };

  return {
    ways({ metal, n, F0 }) {
      if (!metal) {
        const ior = { KHR_materials_ior: { ior: n[0] } };
        return {
          "glTF, ior": { pbrMetallicRoughness: plain, extensions: ior },
          "glTF, ior and specular": {
            pbrMetallicRoughness: plain,
            extensions: { ...ior, ...specular },
          },
        };
      }
      return {
        "glTF, base color": {
          pbrMetallicRoughness: {
            metallicFactor: 1,
            roughnessFactor: 0,
            baseColorFactor: [...F0, 1],
          },
        },
      };
    },
    async reflect(_way, typed, under, theta) {
      const text = new TextEncoder().encode(JSON.stringify(gltf(typed)));
      const asset = loader.createAsset(text);
      await new Promise((resolve) => asset.loadResources(resolve, null, "", null));
      scene.addEntities(asset.getRenderableEntities());
      even.setIntensity(under === "light" ? 0 : 1);
      if (under === "light") scene.addEntity(sun);
      suns.setDirection(suns.getInstance(sun), [Math.sin(theta), 0, -Math.cos(theta)]);
      camera.lookAt(
        [DISTANCE * Math.sin(theta), 0, DISTANCE * Math.cos(theta)],
        [0, 0, 0],
        [0, 1, 0],
      );
      for (let i = 0; i < 3; i++) renderer.render(swapChain, view);
      engine.execute();
      const pixels = new Float32Array(64);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
      gl.readPixels(0, 0, 4, 4, gl.RGBA, gl.FLOAT, pixels);
      scene.removeEntities(asset.getRenderableEntities());
      scene.remove(sun);
      loader.destroyAsset(asset);
      return pixels;
    },
  };
}
