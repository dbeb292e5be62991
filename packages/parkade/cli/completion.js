// @ts-check
// `parkade completion`: what a shell offers after `parkade`, made of the commands' own table.
import { planners, scenarios } from "../node.js";
import { write } from "./output.js";
import { Refused } from "./refusal.js";

/** Commands whose first word is a scene. */
const OF_SCENES = ["plan", "check", "judge", "bench", "scenario"];

/**
 * @param {Record<string, import("./commands.js").Command>} commands
 * @returns {import("./commands.js").Run}
 */
export const completion = (commands) => async (places) => {
  const [shell, ...more] = places;
  if (shell === undefined || more.length > 0) throw new Refused("which shell? `parkade completion bash`, zsh or fish");
  const words = Object.fromEntries(
    Object.entries(commands).map(([name, { options }]) => [
      name,
      Object.keys(options ?? {}).map((option) => `--${option}`),
    ]),
  );
  const scenes = scenarios().map(({ id }) => id),
    ids = planners().map(({ id }) => id);
  const kind = shell === "bash" || shell === "zsh" || shell === "fish" ? shell : undefined;
  if (kind === undefined) throw new Refused(`completion ${shell}: must be one of bash, zsh, fish`);
  await write(kind === "fish" ? fish(words, scenes, ids) : bash(words, scenes, ids, kind === "zsh"));
  return 0;
};

/** @param {Record<string, string[]>} words @param {string[]} scenes @param {string[]} ids @param {boolean} isZsh */
function bash(words, scenes, ids, isZsh) {
  const cases = Object.entries(words).map(
    ([name, options]) =>
      `    ${name}) words="${[...options, ...(OF_SCENES.includes(name) ? scenes : [])].join(" ")}" ;;`,
  );
  // Zsh completes bash's way once its own completion runs, which a shell without settings has not begun.
  const begun =
    "(( $+functions[compdef] )) || { autoload -Uz compinit && compinit; }\nautoload -U +X bashcompinit && " +
    "bashcompinit\n";
  return `${isZsh ? begun : ""}_parkade() {
  local word="\${COMP_WORDS[COMP_CWORD]}" before="\${COMP_WORDS[COMP_CWORD-1]}" words
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="${Object.keys(words).join(" ")}"
  elif [ "$before" = --planner ]; then
    words="${ids.join(" ")}"
  else
    case "\${COMP_WORDS[1]}" in
${cases.join("\n")}
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _parkade parkade
`;
}

/** @param {Record<string, string[]>} words @param {string[]} scenes @param {string[]} ids */
function fish(words, scenes, ids) {
  const lines = Object.entries(words).flatMap(([name, options]) => {
    const within = `complete -c parkade -n "__fish_seen_subcommand_from ${name}"`;
    return [
      `complete -c parkade -n __fish_use_subcommand -f -a ${name}`,
      ...options.map((option) =>
        option === "--planner" ? `${within} -x -l planner -a "${ids.join(" ")}"` : `${within} -l ${option.slice(2)}`,
      ),
      ...(OF_SCENES.includes(name) ? [`${within} -a "${scenes.join(" ")}"`] : []),
    ];
  });
  return `${lines.join("\n")}\n`;
}
