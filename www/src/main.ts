import { init, version } from "parkade";

await init();
const output = document.querySelector("#version");
if (output) output.textContent = version();
