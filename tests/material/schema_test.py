"""Holds the JSON Schema of material files to the loader's verdicts.

usage: schema_test.py VERDICTS_PROGRAM SCHEMA MATERIALS_FOLDER
"""

import json
import pathlib
import subprocess
import sys

import jsonschema


def parse_strictly(data: bytes):
    """JSON as the standard has it: no NaN or Infinity, UTF-8, finite numbers."""

    def refuse(name):
        raise ValueError(f"{name} is not JSON")

    value = json.loads(data.decode("utf-8"), parse_constant=refuse)
    json.dumps(value, allow_nan=False)
    return value


def schema_verdict(validator, data: bytes) -> str:
    """'accepted', or what is wrong."""
    try:
        value = parse_strictly(data)
    except (ValueError, RecursionError) as error:
        return f"not JSON: {error}"
    error = jsonschema.exceptions.best_match(validator.iter_errors(value))
    return "accepted" if error is None else error.message


def disagreement(case, seen: str) -> bool:
    loader_accepts = case["loader"] == "accepted"
    schema_accepts = seen == "accepted"
    if case["schema_sees"]:
        return loader_accepts != schema_accepts
    # Beyond a schema's means: only the loader refuses it, or else the case is marked wrongly.
    return loader_accepts


def main() -> int:
    program, schema_file, materials = sys.argv[1:]
    schema = json.loads(pathlib.Path(schema_file).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)

    failures = 0
    cases = json.loads(subprocess.run([program], check=True, capture_output=True).stdout)
    for case in cases:
        seen = schema_verdict(validator, bytes(case["bytes"]))
        if disagreement(case, seen):
            failures += 1
            print(f"{case['name']}: loader: {case['loader']}; schema: {seen}")
    bundled = sorted(pathlib.Path(materials).glob("*.json"))
    for file in bundled:
        seen = schema_verdict(validator, file.read_bytes())
        if seen != "accepted":
            failures += 1
            print(f"{file.name}: {seen}")
    print(f"{len(cases)} cases and {len(bundled)} bundled materials, {failures} disagreements")
    return 1 if failures or not cases or not bundled else 0


if __name__ == "__main__":
    sys.exit(main())
