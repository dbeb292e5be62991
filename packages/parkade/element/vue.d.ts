/** `<parkade-playground>` in templates of Vue: `import type {} from "parkade/element/vue"`. */
import type { DefineComponent } from "vue";
import type { PlaygroundAttributes } from "../element.js";

declare module "vue" {
  interface GlobalComponents {
    "parkade-playground": DefineComponent<PlaygroundAttributes>;
  }
}
