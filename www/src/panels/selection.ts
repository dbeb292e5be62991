import type { Pose } from "parkade";
import type { CostArea, MovingObstacle, Obstacle, Road, Slot } from "../scene/scenario";
import { css, html, nothing, type TemplateResult } from "lit";
import { translatorAt } from "../i18n/translator";
import {
  findCost,
  findMoving,
  findObstacle,
  findSlot,
  goalPose,
  movePose,
  setGoalFromSlot,
  updateMoving,
  updateObstacle,
  updateSlot,
} from "../scene/model";
import { removeCost, removeMoving, removeObstacle, removeSlot } from "../scene/removal";
import { reweigh } from "../scene/costs";
import { laneWidthOf, lanesOf } from "../scene/road-width";
import { turnRows } from "../scene/slot-fit";
import type { Scene, State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { isChecked, type On } from "./inputs";
import { icon } from "../styles/icons";
import "./ground-card";
import "./goal-card";
import "./group-card";
import { objectName } from "./objects";

const say = translatorAt("selected");

const DEGREES = 180 / Math.PI;

interface Field {
  label: string;
  unit: string;
  value: number;
  digits: number;
  step: number;
  min?: number;
  max?: number;
  apply: (value: number) => Scene;
}

/** The numbers of what is selected; typing them is one undo step each. */
export class SelectionCard extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    .slots { color: var(--parkade-t2); } parkade-ground + p { margin-top: 8px; }
    label.check { display: flex; gap: 8px; align-items: center; }
    label.check input { accent-color: var(--parkade-accent); }
    .danger { color: var(--parkade-err); margin-left: -8px; }
    .small { height: 28px; font-size: 12px; }
  `,
  ];

  protected override redrawMs = 100;

  protected watches(): readonly (keyof State)[] {
    return ["scene", "selection", "results"];
  }

  protected override render(): TemplateResult {
    const { selection, scene } = this.state;
    if (selection?.kind === "start" || selection?.kind === "goal") return this.pose(selection.kind);
    if (selection?.kind === "group") return html`<parkade-group .app=${this.app}></parkade-group>`;
    const obstacle = selection?.kind === "obstacle" ? findObstacle(scene, selection.id) : undefined;
    if (obstacle) return this.obstacle(obstacle);
    const moving = selection?.kind === "moving" ? findMoving(scene, selection.id) : undefined;
    if (moving) return this.moving(moving);
    const cost = selection?.kind === "cost" ? findCost(scene, selection.id) : undefined;
    if (cost) return this.cost(cost);
    const slot = selection?.kind === "slot" ? findSlot(scene, selection.id) : undefined;
    if (slot) return this.slotCard(slot);
    return html`<div
      class="head"><h2>${this.t("ground.title")}</h2><span>${this.t("inspect.none")}</span></div><parkade-ground
      .app=${this.app}></parkade-ground><p>${this.t("inspect.noneHelp")}</p>`;
  }

  private heading(name: string): TemplateResult {
    return html`<div class="head"><h2>${name}</h2><span>${this.t("inspect.selected")}</span></div>`;
  }

  private pose(kind: "start" | "goal"): TemplateResult {
    const { scene } = this.state;
    const pose = kind === "start" ? scene.start : goalPose(scene);
    const move = (patch: Partial<Pose>): Scene => movePose(this.state.scene, kind, { ...pose, ...patch });
    return html`${this.heading(this.t(`inspect.${kind}`))}
      ${this.fields(poseFields(pose, move))}
      ${kind === "goal" ? html`<parkade-goal .app=${this.app}></parkade-goal>` : nothing}`;
  }

  private obstacle(obstacle: Obstacle): TemplateResult {
    return html`${this.heading(objectName(this.state.lang, obstacle))}${
      obstacle.type === "road" ? this.road(obstacle) : this.fields(this.obstacleFields(obstacle))
    }
      ${this.deleteRow(() => this.edit(removeObstacle(this.state.scene, obstacle.id)))}`;
  }

  private obstacleFields(obstacle: Obstacle): Field[] {
    const apply = (next: Obstacle): Scene => updateObstacle(this.state.scene, obstacle.id, next);
    if (obstacle.type === "car")
      return poseFields(obstacle.pose, (patch) => apply({ ...obstacle, pose: { ...obstacle.pose, ...patch } }));
    if (obstacle.type === "wall") {
      return [
        metres(
          this.t("option.thickness"),
          obstacle.thickness ?? 0,
          (thickness) => apply({ ...obstacle, thickness }),
          0,
        ),
      ];
    }
    if (obstacle.type !== "rectangle") return [];
    const { center, size, heading = 0 } = obstacle;
    return [
      metres("x", center[0], (x) => apply({ ...obstacle, center: [x, center[1]] })),
      metres("y", center[1], (y) => apply({ ...obstacle, center: [center[0], y] })),
      angle(heading, (value) => apply({ ...obstacle, heading: value })),
      metres(say(this.state.lang, "length"), size[0], (along) => apply({ ...obstacle, size: [along, size[1]] }), 0.05),
      metres(say(this.state.lang, "width"), size[1], (across) => apply({ ...obstacle, size: [size[0], across] }), 0.05),
    ];
  }

  private road(road: Road): TemplateResult {
    const { lang } = this.state,
      apply = (patch: Partial<Road>): Scene => updateObstacle(this.state.scene, road.id, { ...road, ...patch });
    const [along, against] = lanesOf(road);
    const lanes = (label: string, value: number, put: (n: number) => [number, number]): Field => ({
      label,
      unit: "",
      value,
      digits: 0,
      step: 1,
      min: value === along + against ? 1 : 0,
      max: 8,
      apply: (n) => apply({ lanes: put(Math.round(n)) }),
    });
    return html`${this.fields(
      [
        lanes(say(lang, "along"), along, (n) => [n, against]),
        lanes(say(lang, "against"), against, (n) => [along, n]),
        metres(say(lang, "laneWidth"), laneWidthOf(road), (laneWidth) => apply({ laneWidth }), 1),
        metres(say(lang, "bend"), road.radius ?? 20, (radius) => apply({ radius }), 1),
        {
          label: say(lang, "limit"),
          unit: "m/s",
          value: road.speed ?? 0,
          digits: 2,
          step: 0.5,
          min: 0,
          apply: (speed) => withoutSpeed(this.state.scene, { ...road, speed }),
        },
      ],
      2,
    )}
      <div class="row"><label class="check"><input type="checkbox" .checked=${road.kerbs ?? true}
        @change=${(e: Event) => this.edit(apply({ kerbs: isChecked(e) }))}>${say(lang, "kerbs")}</label></div>
      <p>${say(lang, "vertices")}</p>`;
  }

  private moving(one: MovingObstacle): TemplateResult {
    const patch = (change: Partial<MovingObstacle>): Scene => updateMoving(this.state.scene, one.id, change);
    const { lang } = this.state,
      [length, width] = one.size;
    return html`${this.heading(this.t("thing.movingName"))}
      ${this.fields(
        [
          {
            label: say(lang, "speed"),
            unit: "m/s",
            value: one.speed,
            digits: 2,
            step: 0.1,
            min: 0.05,
            apply: (speed) => patch({ speed }),
          },
          {
            label: say(lang, "starts"),
            unit: "s",
            value: one.start ?? 0,
            digits: 1,
            step: 0.5,
            min: 0,
            apply: (start) => patch({ start }),
          },
          metres(say(lang, "length"), length, (to) => patch({ size: [to, width] }), 0.05),
          metres(say(lang, "width"), width, (to) => patch({ size: [length, to] }), 0.05),
        ],
        2,
      )}
      ${this.deleteRow(() => this.edit(removeMoving(this.state.scene, one.id)))}`;
  }

  private cost({ id, weight }: CostArea): TemplateResult {
    const apply = (typed: number): Scene => reweigh(this.state.scene, id!, Math.round(typed));
    return html`${this.heading(this.t("thing.costName"))}
      ${this.fields([
        { label: this.t("option.weight"), unit: "×", value: weight, digits: 0, step: 1, min: 1, max: 10, apply },
      ])}
      <p>${say(this.state.lang, "cost")}</p>
      ${this.deleteRow(() => this.edit(removeCost(this.state.scene, id!)))}`;
  }

  private slotCard(slot: Slot): TemplateResult {
    const id = slot.id;
    const patch = (change: Partial<Slot>): Scene => updateSlot(this.state.scene, id, change);
    const goal = this.state.scene.goal;
    const isGoal = "slot" in goal && goal.slot === id;
    return html`${this.heading(`${this.t("thing.slotName")} · ${this.t(`option.${slot.kind}`)}`)}
      ${this.fields(poseFields(slot, patch))}
      ${this.fields([
        metres(this.t("option.width"), slot.width, (width) => patch({ width }), 0.5),
        metres(this.t("option.depth"), slot.length, (length) => patch({ length }), 0.5),
      ])}
      <div class="row">
        <label class="check"><input type="checkbox" .checked=${slot.occupied ?? false} ?disabled=${isGoal}
          @change=${(e: Event) => this.edit(patch({ occupied: isChecked(e) }))}>${this.t("inspect.occupied")}</label>
        <button class="button outline small to-end" ?disabled=${isGoal || (slot.occupied ?? false)}
          @click=${() => this.edit(setGoalFromSlot(this.state.scene, id))}>${this.t("inspect.makeGoal")}</button>
      </div>
      <div class="row"><button class="button outline small"
        @click=${() =>
          this.edit(
            turnRows(this.state.scene, [id]),
          )}>${icon("flip", 14)}${say(this.state.lang, "aisle")}</button></div>
      ${
        isGoal
          ? html`<p>${this.t("inspect.goalSlot")}</p>`
          : this.deleteRow(() => this.edit(removeSlot(this.state.scene, id)))
      }`;
  }

  private fields(fields: readonly Field[], across = 3): TemplateResult {
    const rows: Field[][] = [];
    for (let i = 0; i < fields.length; i += across) rows.push(fields.slice(i, i + across));
    return html`${rows.map((row) => html`<div class="row">${row.map((field) => this.field(field))}</div>`)}`;
  }

  private field({ label, unit, value, digits, step, min, max, apply }: Field): TemplateResult {
    return html`<label class="field"><span>${label}</span><input type="number" step=${step} min=${min ?? nothing}
      max=${max ?? nothing} .value=${value.toFixed(digits)}
      @change=${({ currentTarget: input }: On<HTMLInputElement>) => {
        const typed = Number(input.value);
        if (
          input.value === "" ||
          !Number.isFinite(typed) ||
          (min !== undefined && typed < min) ||
          (max !== undefined && typed > max)
        )
          input.value = value.toFixed(digits);
        else this.edit(apply(typed));
      }}><span>${unit}</span></label>`;
  }

  private deleteRow(run: () => void): TemplateResult {
    return html`<div class="row"><button class="button danger small"
      @click=${run}>${icon("trash", 14)}${this.t("inspect.delete")}</button><span class="keys to-end">Del</span></div>`;
  }

  private edit(scene: Scene): void {
    this.app.store.edit(scene);
  }
}

/** A limit of 0 is none. */
function withoutSpeed(scene: Scene, { speed, ...road }: Road): Scene {
  return updateObstacle(scene, road.id, speed ? { ...road, speed } : road);
}

function poseFields(pose: Pose, move: (patch: Partial<Pose>) => Scene): Field[] {
  return [
    metres("x", pose.x, (x) => move({ x })),
    metres("y", pose.y, (y) => move({ y })),
    angle(pose.heading, (heading) => move({ heading })),
  ];
}

function metres(label: string, value: number, apply: (value: number) => Scene, min?: number): Field {
  return { label, unit: "m", value, digits: 2, step: 0.1, apply, ...(min === undefined ? {} : { min }) };
}

function angle(value: number, apply: (value: number) => Scene): Field {
  return {
    label: "θ",
    unit: "°",
    value: value * DEGREES,
    digits: 1,
    step: 1,
    apply: (degrees) => apply(degrees / DEGREES),
  };
}

customElements.define("parkade-selection", SelectionCard);
