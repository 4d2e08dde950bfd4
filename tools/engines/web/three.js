// three.js: a large plane below an orthographic camera, float pixels, no tone mapping.
import * as THREE from "three";

const DISTANCE = 10;

export async function open() {
  const renderer = new THREE.WebGLRenderer({ canvas: document.createElement("canvas") });
  renderer.toneMapping = THREE.NoToneMapping;
  const target = new THREE.WebGLRenderTarget(4, 4, { type: THREE.FloatType });
  const white = new THREE.Scene();
  white.background = new THREE.Color(1, 1, 1);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0, 0, 0);
  const even = new THREE.PMREMGenerator(renderer).fromScene(white).texture;
  const plane = new THREE.Mesh(new THREE.PlaneGeometry(1000, 1000));
  const light = new THREE.DirectionalLight(0xffffff, 1);
  scene.add(plane, light, light.target);
  const camera = new THREE.OrthographicCamera(-0.01, 0.01, 0.01, -0.01, 0.1, 100);

  return {
    ways(medium) {
      if (!medium.metal) return { ior: { ior: medium.n[0], color: [0, 0, 0], roughness: 0 } };
      return { color: { color: medium.F0, metalness: 1, roughness: 0 } };
    },
    reflect(way, typed, under, theta) {
      const { color, specularColor, ...numbers } = typed;
      const made = new THREE.MeshPhysicalMaterial(numbers);
      const saved = way.endsWith(", saved");
      const material = saved ? new THREE.MaterialLoader().parse(made.toJSON()) : made;
      material.color.setRGB(...color, THREE.LinearSRGBColorSpace);
      if (specularColor)
        material.specularColor.setRGB(...specularColor, THREE.LinearSRGBColorSpace);
      plane.material = material;
      const [x, z] = [DISTANCE * Math.sin(theta), DISTANCE * Math.cos(theta)];
      camera.position.set(x, 0, z);
      camera.up.set(0, 1, 0);
      camera.lookAt(0, 0, 0);
      light.position.set(-x, 0, z);
      light.visible = under === "light";
      scene.environment = under === "light" ? null : even;
      renderer.setRenderTarget(target);
      renderer.render(scene, camera);
      const pixels = new Float32Array(4 * 16);
      renderer.readRenderTargetPixels(target, 0, 0, 4, 4, pixels);
      material.dispose();
      return pixels;
    },
  };
}
