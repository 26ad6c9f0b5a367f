// The row of materials to choose from, each a button with a small sphere of it.

export interface Swatch {
    button: HTMLButtonElement;
    canvas: HTMLCanvasElement;
}

const SWATCH_PIXELS = 112;

export function addSwatch(row: HTMLElement, label: string, chosen: () => void): Swatch {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = SWATCH_PIXELS;
    const name = document.createElement("span");
    name.textContent = label;
    const button = document.createElement("button");
    button.type = "button";
    button.append(canvas, name);
    button.addEventListener("click", chosen);
    row.append(button);
    return { button, canvas };
}

// Marks `button`, or none, as the chosen one of its row.
export function markChosen(row: HTMLElement, button: HTMLButtonElement | undefined): void {
    for (const other of row.querySelectorAll("button")) {
        other.setAttribute("aria-pressed", String(other === button));
    }
    button?.scrollIntoView({ block: "nearest", inline: "center" });
}
