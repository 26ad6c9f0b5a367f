// A value of a material file together with where it stands, and its typed readings. What does not
// fit throws MaterialError with the file, the JSON pointer, the value and what would have fitted.
import type { Rgb } from "./material";
import type { Range } from "./ranges";

export class MaterialError extends Error {}

// A material that is well described, and that the page does not show.
export class NotShownError extends MaterialError {}

function isObject(value: unknown): value is Record<string, unknown> {
    return typeof value === "object" && value !== null && !Array.isArray(value);
}

export class Place {
    constructor(
        private readonly origin: string,
        private readonly value: unknown,
        private readonly pointer = "",
    ) {}

    fail(problem: string): never {
        throw new MaterialError(this.message(problem));
    }

    notShown(problem: string): never {
        throw new NotShownError(this.message(problem));
    }

    isString(): boolean {
        return typeof this.value === "string";
    }

    isArray(): boolean {
        return Array.isArray(this.value);
    }

    // An object whose every key is one of `allowed` or "comment".
    expectObject(...allowed: string[]): void {
        for (const key of Object.keys(this.object())) {
            if (key !== "comment" && !allowed.includes(key)) {
                this.fail(`the key '${key}' is not one of: ${allowed.join(", ")}`);
            }
        }
    }

    find(key: string): Place | undefined {
        const object = this.object();
        return Object.hasOwn(object, key) ? this.child(key, object[key]) : undefined;
    }

    member(key: string): Place {
        return this.find(key) ?? this.fail(`the key '${key}' is missing`);
    }

    elements(): Place[] {
        if (!Array.isArray(this.value)) {
            this.fail(`${this.text()} is not an array`);
        }
        return this.value.map((element: unknown, index) => this.child(String(index), element));
    }

    string(): string {
        return typeof this.value === "string" ? this.value : this.fail(`${this.text()} is no string`);
    }

    choice<T extends string>(...choices: T[]): T {
        const value = this.string();
        const found = choices.find((choice) => choice === value);
        return found ?? this.fail(`'${value}' is not one of: ${choices.join(", ")}`);
    }

    number(range: Range): number {
        if (isObject(this.value) && "texture" in this.value) {
            this.notShown("this page does not show textures");
        }
        if (typeof this.value !== "number") {
            this.fail(`${this.text()} is not a number`);
        }
        if (!(this.value >= range.low && this.value <= range.high)) {
            this.fail(`${this.value} is outside [${range.low}, ${range.high}]`);
        }
        return this.value;
    }

    rgb(range: Range): Rgb {
        const [r, g, b, ...rest] = this.elements();
        if (r === undefined || g === undefined || b === undefined || rest.length > 0) {
            this.fail("expected three numbers: red, green, blue");
        }
        return [r.number(range), g.number(range), b.number(range)];
    }

    private message(problem: string): string {
        return `${this.origin}: ${this.pointer || "/"}: ${problem}`;
    }

    private object(): Record<string, unknown> {
        return isObject(this.value) ? this.value : this.fail(`${this.text()} is not an object`);
    }

    private child(token: string, value: unknown): Place {
        return new Place(this.origin, value, `${this.pointer}/${token}`);
    }

    private text(): string {
        return JSON.stringify(this.value) ?? "nothing";
    }
}
