/** An event that is listened to on such an element. */
export type On<Listening extends Element, Kind extends Event = Event> = Kind & { readonly currentTarget: Listening };

/** What a form's control holds when it tells of a change. */
const controlOf = (event: Event): HTMLInputElement => event.target as HTMLInputElement;

export const valueOf = (event: Event): string => controlOf(event).value;
/** NaN where the text is no number. */
export const numberOf = (event: Event): number => Number(valueOf(event));
export const isChecked = (event: Event): boolean => controlOf(event).checked;
