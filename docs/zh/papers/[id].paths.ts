import { papers } from "../../.vitepress/papers";

export default { paths: () => papers("zh") };
