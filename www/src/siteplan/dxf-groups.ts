/** DXF as text: pairs of a group code and a value, gathered to records that begin with code 0. */
import { SitePlanError } from "./site-plan";
import { rule } from "../i18n/rule";

export interface Group {
  code: number;
  value: string;
  /** Of the value, from 1. */
  line: number;
}

/** A record: its type, and the groups up to the next one. */
export interface DxfRecord {
  type: string;
  line: number;
  groups: Group[];
}

/** No record that holds a drawing's line has more groups; more are damage or a picture's bytes. */
const MOST_GROUPS = 500_000;

/** Records one after the other: the file is never held a second time. */
export function* recordsOf(text: string): Generator<DxfRecord> {
  let record: DxfRecord | null = null;
  for (const group of groupsOf(text)) {
    if (group.code !== 0) {
      if (!record)
        throw new SitePlanError(rule`must begin with "0" and "SECTION", got ${shown(group.value)}`, group.line);
      if (isRead(group.code)) record.groups.push(group);
      if (record.groups.length > MOST_GROUPS)
        throw new SitePlanError(rule`an entity must have at most ${MOST_GROUPS} groups`, group.line);
      continue;
    }
    if (record) yield record;
    if (group.value === "EOF") return;
    record = { type: group.value, line: group.line, groups: [] };
  }
  throw new SitePlanError(rule`the file ends before its end mark EOF; it may be cut off`);
}

/** Handles, subclass marks and other programs' data are left out. */
const isRead = (code: number): boolean => code < 100 || code === 230;

function* groupsOf(text: string): Generator<Group> {
  let at = 0,
    line = 0;
  const next = (): string | null => {
    if (at >= text.length) return null;
    const end = text.indexOf("\n", at),
      stop = end < 0 ? text.length : end,
      one = text.slice(at, stop).trim();
    at = stop + 1;
    line++;
    return one;
  };
  for (;;) {
    const head = next();
    if (head === null) return;
    if (!/^-?\d{1,4}$/.test(head)) {
      // Empty lines may follow the end mark only, which ends the reading.
      throw new SitePlanError(rule`must be a group code, got ${shown(head)}`, line);
    }
    const value = next();
    if (value === null) throw new SitePlanError(rule`the file ends before its end mark EOF; it may be cut off`, line);
    if (Number(head) !== 999) yield { code: Number(head), value, line };
  }
}

const shown = (text: string): string => JSON.stringify(text.length > 40 ? `${text.slice(0, 40)}…` : text);

/** The first value of a code as a number; `otherwise` where it is absent. */
export function numberIn(record: DxfRecord, code: number, otherwise?: number): number {
  const group = record.groups.find((one) => one.code === code);
  if (!group) {
    if (otherwise !== undefined) return otherwise;
    throw new SitePlanError(rule`${record.type} must have a group ${code}`, record.line);
  }
  return numberOf(group);
}

export function numberOf({ value, line, code }: Group): number {
  const read = value === "" ? Number.NaN : Number(value);
  if (!Number.isFinite(read)) throw new SitePlanError(rule`group ${code} must be a number, got ${shown(value)}`, line);
  return read;
}

export const textIn = (record: DxfRecord, code: number, otherwise: string): string =>
  record.groups.find((one) => one.code === code)?.value ?? otherwise;
