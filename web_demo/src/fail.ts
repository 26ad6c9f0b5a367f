// The one place where the page says that it cannot go on.

// Shows `message` instead of the page. The first message stays: what fails afterwards is its
// consequence.
function show(message: string): void {
    const panel = document.querySelector<HTMLElement>("#failure");
    const text = document.querySelector<HTMLElement>("#failure-message");
    if (panel !== null && text !== null && panel.hidden) {
        text.textContent = message;
        panel.hidden = false;
    }
}

// Shows `message` and ends what was being done.
export function fail(message: string): never {
    show(message);
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

// Shows what nothing catches.
export function showUncaughtErrors(): void {
    addEventListener("error", (event) => show(event.message));
    addEventListener("unhandledrejection", ({ reason }) => {
        show(reason instanceof Error ? reason.message : String(reason));
    });
}
