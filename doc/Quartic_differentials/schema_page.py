# Makes a page of the manual of a JSON schema: `schema_page.py FILE.schema.json` prints it as Markdown for Doxygen, with a
# row for every field, however deep, and the schema at the end.

import json
import os
import re
import sys


def plain(text):
    """text in which Doxygen and Markdown find no commands, links or cells, but for code in backquotes"""
    return re.sub(r"([\\@%*_<>|#&])", r"\\\1", text)


def described(text):
    """a description: code in backquotes stays as it is"""
    return "".join(part if k % 2 else plain(part) for k, part in enumerate(re.split(r"(`[^`]*`)", text)))


def type_of(schema):
    """what a reader calls the type of a value"""
    if "enum" in schema:
        return " or ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
    if "const" in schema:
        return f"always `{json.dumps(schema['const'])}`"
    if schema["type"] == "array":
        size = f" of {schema['minItems']}" if schema.get("minItems") == schema.get("maxItems", -1) else ""
        return "list" + size
    return schema["type"]


class Page:
    def __init__(self, root):
        self.root = root
        self.rows = []
        self.add_fields("", root)

    def resolved(self, schema):
        """the schema a reference names, with the description that stands beside the reference"""
        if "$ref" not in schema:
            return schema
        target = self.root["definitions"][schema["$ref"].rsplit("/", 1)[1]]
        return {**target, **{key: text for key, text in schema.items() if key == "description"}}

    def add_fields(self, path, schema):
        for name, field in schema.get("properties", {}).items():
            self.add_field(path + name, field, name in schema["required"])
        for pattern, field in schema.get("patternProperties", {}).items():
            self.add_field(path + "…", field, False)

    def add_field(self, path, field, is_required):
        field = self.resolved(field)
        inner, suffix, type_name, is_told = field, "", type_of(field), False
        while inner.get("type") == "array":
            inner = self.resolved(inner["items"])
            suffix += "[]"
            if not is_told:
                type_name += ", each: " + inner.get("description", type_of(inner))
            is_told = is_told or "description" in inner
        self.rows.append((path, type_name, is_required, field["description"]))
        if inner.get("type") == "object":
            self.add_fields(path + suffix + ".", inner)

    def text(self, label, file):
        lines = [f"# {self.root['title']} {{#{label}}}", "", described(self.root["description"]), "",
                 "| Field | Type | Meaning |", "|:---|:---|:---|"]
        for path, type_name, is_required, description in self.rows:
            optional = "" if is_required else "<br>optional"
            lines.append(f"| `{path}` | {described(type_name)}{optional} | {described(description)} |")
        return "\n".join(lines + ["", "## The schema", "", f"\\include {file}", ""])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        page = Page(json.load(file))
    name = os.path.basename(sys.argv[1])
    print(page.text("json_" + name.split(".")[0], name))
