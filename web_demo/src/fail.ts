// The one place where the page says that it cannot go on.

// Shows `message` instead of the page and ends what was being done. The first message stays: what
// fails afterwards is its consequence.
export function fail(message: string): never {
    const panel = document.querySelector<HTMLElement>("#failure");
    const text = document.querySelector<HTMLElement>("#failure-message");
    if (panel !== null && text !== null && panel.hidden) {
        text.textContent = message;
        panel.hidden = false;
    }
    throw new Error(message);
}

export function assertPresent<T>(value: T | null | undefined, message: string): asserts value is T {
    if (value === null || value === undefined) {
        fail(message);
    }
}

// The element of the page that `selector` finds.
export function element<T extends Element>(selector: string): T {
    const found = document.querySelector<T>(selector);
    assertPresent(found, `The page has no ${selector}.`);
    return found;
}

// Sends what nothing catches to `fail`.
export function failOnUncaughtErrors(): void {
    addEventListener("error", (event) => fail(event.message));
    addEventListener("unhandledrejection", (event) => fail(String(event.reason)));
}
