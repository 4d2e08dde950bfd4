/**
 * The ray at the surface, to scale: arrows as long as the light they carry, angles as they are, media
 * tinted by their index. It shows what it is given and computes no optics.
 */

import { put, px, show } from "../draw/svg.js";
import { angle, percent } from "../numbers/format.js";
import { h, listen, setText } from "../page/dom.js";
import { watchSize } from "../plot/figure.js";
import {
  angleAt,
  arcPath,
  at,
  createScene,
  direction,
  isRight,
  rightAnglePath,
  seenAt,
  setArrow,
  setDecay,
  setIncident,
  setLine,
  setMirror,
  setScale,
  setSigns,
  stageOf,
  tint,
} from "./scene.js";
import { createAnnotations, description } from "./words.js";

/** ms without a change after which the picture is described. */
const STILL = 150;

/**
 * What of each polarization is passed on, of the light that is sent in.
 * @param {DiagramValues} values
 */
function sharesOf({ polarization, R, Rs, Rp, T, Ts = 1 - Rs, Tp = 1 - Rp }) {
  const s = polarization === "p" ? 0 : 1;
  const p = polarization === "s" ? 0 : 1;
  const [share, rest] = { s: [Rs, Ts], p: [Rp, Tp], unpolarized: [R, T] }[polarization];
  return {
    share: share ?? 0,
    rest: rest ?? 0,
    incident: { s, p },
    reflected: { s: s * Rs, p: p * Rp },
    refracted: { s: s * Ts, p: p * Tp },
  };
}

/**
 * @param {HTMLElement} element
 * @param {DragActions} actions
 */
export function createDiagram(element, actions) {
  element.classList.add("diagram");
  element.setAttribute("role", "figure");
  element.setAttribute("aria-label", "Ray at the surface");
  const scene = createScene();
  /** Fetched with the first white light. @type {ReturnType<typeof import("./fan.js").createFan> | null} */
  let fan = null;
  element.append(scene.root);
  const handle = h("div.diagram-handle", {
    tabindex: "0",
    role: "slider",
    "aria-label": "Incident ray, angle of incidence",
    "aria-valuemin": "0",
    "aria-valuemax": "90",
  });
  const said = h("p.diagram-said");
  element.append(handle, said);

  const words = createAnnotations(scene);
  const host = watchSize(element, element, () => measure());
  let stage = stageOf(480, 480, host.theme().unit);
  /** @type {DiagramValues | null} */
  let values = null;

  /** What depends on the size alone. */
  const layStage = () => {
    const { width, height, x, y, length, normal } = stage;
    // A size of its own: one that follows the host's is laid out anew in each pass over the page.
    put(scene.root, "width", width);
    put(scene.root, "height", height);
    put(scene.upper, "width", width);
    put(scene.upper, "height", y);
    for (const rect of [scene.lower, scene.dark, scene.light]) {
      put(rect, "y", y);
      put(rect, "width", width);
      put(rect, "height", height - y);
    }
    setLine(scene.normal, { x, y: normal.top }, { x, y: normal.bottom });
    setLine(scene.surface, { x: 0, y }, { x: width, y });
    put(scene.protractor, "d", arcPath(stage, length, 90, "incident"));
    setMirror(scene, stage);
    setScale(scene, stage);
  };

  /** Light from the denser side comes from below, but nothing is turned over under the hand. */
  const turn = (/** @type {DiagramValues} */ { interface: { n_i, n_t, k_t }, held }) => {
    const mirror = held ? stage.mirror : k_t === 0 && n_i > n_t;
    if (mirror === stage.mirror) return;
    stage = { ...stage, mirror };
    setMirror(scene, stage);
    setScale(scene, stage);
  };

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let speech;
  /** @param {Parameters<typeof description>[0]} shown what is drawn, said once it stands still */
  const describe = (shown) => {
    clearTimeout(speech);
    speech = setTimeout(() => {
      said.textContent = description(shown);
    }, STILL);
  };

  const render = () => {
    if (!values) return;
    turn(values);
    const { theta_i_deg, theta_t_deg, tir, polarization } = values;
    const { n_i, n_t, k_t } = values.interface;
    const { share, rest: passed, incident, reflected, refracted } = sharesOf(values);
    const rest = tir ? 0 : passed;
    const absorbing = k_t > 0;
    const depth = tir || absorbing ? values.penetration_depth_wavelengths : null;

    element.toggleAttribute("data-absorbing", absorbing);
    // on the media alone: what is set on the host is inherited, and all of it is styled anew
    put(scene.upper, "style", `--tint: ${(tint(n_i) * 100).toFixed(1)}%`);
    put(scene.lower, "style", `--tint: ${(tint(n_t) * 100).toFixed(1)}%`);
    setDecay(scene.dark, scene.darkness, stage, absorbing ? depth : null);
    setDecay(scene.light, scene.glow, stage, tir ? depth : null);
    show(scene.scaleBar, depth !== null);
    show(scene.scaleText, depth !== null);

    const back = direction(theta_i_deg, "incident");
    const up = direction(theta_i_deg, "reflected");
    const down = tir || theta_t_deg === null ? null : direction(theta_t_deg, "refracted");
    const source = at(stage, back, stage.length);
    setIncident(scene.incident, stage, back);
    setLine(scene.grip, source, stage);
    put(scene.arcIncident, "d", arcPath(stage, stage.arc, theta_i_deg, "incident"));
    setLine(scene.pathReflected, stage, at(stage, up, stage.length));
    setArrow(scene.reflected, stage, up, share);
    // head on, the reflected arrow lies over the incident ray and needs an edge of its own
    show(scene.reflected.casing, theta_i_deg < 4);
    show(scene.pathRefracted, down !== null);
    show(scene.arcRefracted, down !== null);
    const right = down !== null && isRight(values);
    show(scene.rightAngle, right);
    if (right) put(scene.rightAngle, "d", rightAnglePath(stage, up, down));
    if (down && theta_t_deg !== null) {
      setLine(scene.pathRefracted, stage, at(stage, down, stage.length));
      put(scene.arcRefracted, "d", arcPath(stage, stage.arc, theta_t_deg, "refracted"));
    }
    const rays = values.dispersion ?? [];
    if (fan) fan.update(stage, rays);
    else if (rays.length > 0)
      void import("./fan.js").then(({ createFan }) => {
        fan ??= createFan(scene.refracted.group);
        render();
      });
    setArrow(scene.refracted, stage, down ?? up, down && rays.length === 0 ? rest : 0);
    const both = polarization === "unpolarized";
    const signs = [
      ...setSigns(scene.signs.incident, stage, back, incident, both, null),
      ...setSigns(scene.signs.reflected, stage, up, reflected, both, share),
      ...setSigns(
        scene.signs.refracted,
        stage,
        down ?? up,
        down ? refracted : { s: 0, p: 0 },
        both,
        rest,
        absorbing && depth !== null ? depth * stage.wavelength : null,
      ),
    ];

    words.write({ values, share, rest, depth, back, up, down, source, signs }, stage);

    handle.style.transform = `translate(${px(source.x)}px,${px(seenAt(stage, source.y))}px)`;
    put(handle, "aria-valuenow", Number(theta_i_deg.toFixed(4)));
    put(handle, "aria-valuetext", angle(theta_i_deg, values.angleUnit));
    describe({ ...values, reflected: share, passed: rest, depth });
  };

  const measure = () => {
    const size = host.size();
    if (!size) return;
    const theme = host.theme();
    words.useFaces(theme);
    stage = { ...stageOf(size.width, size.height, theme.unit), mirror: stage.mirror };
    layStage();
    render();
  };
  measure();

  const stopDragging = listenForDrags({
    host: element,
    handle,
    grip: scene.grip,
    stage: () => stage,
    theta: () => values?.theta_i_deg ?? 0,
    named: (event) =>
      values?.landmarks.find((_, index) => lies(event, scene.marks[index]?.name))?.deg,
    actions,
  });

  return {
    /** @param {DiagramValues} next */
    update(next) {
      values = next;
      render();
    },
    destroy() {
      clearTimeout(speech);
      host.stop();
      stopDragging();
      element.replaceChildren();
    },
  };
}

/** @param {PointerEvent} event @param {Element | undefined} element with a name, or with none */
function lies({ clientX, clientY }, element) {
  const box = element?.getBoundingClientRect();
  return (
    box !== undefined &&
    Math.abs(clientX - box.left - box.width / 2) < box.width / 2 &&
    Math.abs(clientY - box.top - box.height / 2) < box.height / 2
  );
}

/** With Shift the ray turns by this share of the pointer's turn. */
const FINE = 0.1;

/** @param {ListenForDragsOptions} task @returns {() => void} stop listening */
export function listenForDrags({ host, handle, grip, stage, theta, named, actions }) {
  /** @type {{id: number, from: number, pointer: number, fine: boolean} | null} */
  let held = null;

  /** @param {PointerEvent} event */
  const pointed = (event) => {
    const bounds = host.getBoundingClientRect();
    const y = seenAt(stage(), event.clientY - bounds.top);
    return angleAt(stage(), { x: event.clientX - bounds.left, y });
  };

  /** @param {PointerEvent} event */
  const release = (event) => {
    if (!held || event.pointerId !== held.id) return;
    held = null;
    host.removeAttribute("data-dragging");
    actions.onSettle?.();
  };
  /** @param {KeyboardEvent} event */
  const kindOf = (event) => {
    const arrow = event.shiftKey ? "fine" : "";
    /** @type {Record<string, string>} */
    const kinds = {
      ArrowRight: `${arrow}+`,
      ArrowUp: `${arrow}+`,
      ArrowLeft: `${arrow}-`,
      ArrowDown: `${arrow}-`,
      PageUp: "page+",
      PageDown: "page-",
      Home: "home",
      End: "end",
    };
    return /** @type {Parameters<NonNullable<DragActions["onStep"]>>[0] | undefined} */ (
      kinds[event.key]
    );
  };
  const listening = new AbortController();
  listen(host, listening.signal, {
    pointerdown(event) {
      if (!event.isPrimary || event.button !== 0) return;
      const taken = event.target === handle || event.target === grip;
      const { y } = stage();
      const above = seenAt(stage(), event.clientY - host.getBoundingClientRect().top) < y;
      if (!taken && (event.pointerType === "touch" || !above)) return;
      host.setPointerCapture(event.pointerId);
      handle.focus({ preventScroll: true });
      event.preventDefault();
      host.toggleAttribute("data-dragging", true);
      const pointer = pointed(event);
      // The handle stays under the point where it was taken; elsewhere the ray comes to the pointer, or to
      // the angle that is named there.
      const from = taken ? theta() : (named(event) ?? pointer);
      held = { id: event.pointerId, from, pointer, fine: event.shiftKey };
      if (!taken) actions.onTheta(from, { fine: event.shiftKey, free: event.altKey });
    },
    pointermove(event) {
      if (!held || event.pointerId !== held.id) return;
      const pointer = pointed(event);
      if (event.shiftKey !== held.fine) {
        held = { id: held.id, from: theta(), pointer, fine: event.shiftKey };
      }
      const turned = (pointer - held.pointer) * (held.fine ? FINE : 1);
      const value = Math.min(90, Math.max(0, held.from + turned));
      actions.onTheta(value, { fine: event.shiftKey, free: event.altKey });
    },
    pointerup: release,
    pointercancel: release,
  });
  listen(handle, listening.signal, {
    keydown(event) {
      const kind = kindOf(event);
      if (!kind || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      actions.onStep?.(kind);
    },
    keyup(event) {
      if (kindOf(event)) actions.onSettle?.();
    },
  });
  return () => listening.abort();
}

export function createSplit() {
  const reflected = h("div");
  const bar = h("div.split-bar", { "aria-hidden": "true" }, reflected);
  const left = h("b");
  const right = h("b");
  const rest = h("span", "transmitted");
  const element = h(
    "div.split",
    bar,
    h("p.split-text", h("span", "reflected ", left), h("span", right, " ", rest)),
  );
  return {
    element,
    /** @param {number} share reflected @param {number} passed @param {boolean} absorbing */
    update(share, passed, absorbing) {
      bar.style.setProperty("--share", String(share));
      setText(left, percent(share));
      setText(right, percent(passed));
      setText(rest, absorbing ? "into the absorber" : "transmitted");
    },
  };
}
