"""A rule in a file: its chances and its schedule; with a shipped rule's name and digest, or another's own words."""

import hashlib
from dataclasses import replace

from game.world.files.checked_table import TableError, shown
from game.world.rules.definition import MOST_INCLUDES, definition_of_texts, is_shipped, load_definition, rule_names
from game.world.rules.rule import SAND, SCHEDULES, Rule
from game.world.rules.rule_text import LARGEST_FILE, RuleError


def encode_rule(rule):
    """Return a rule as a dict for JSON. That of sand has no name, as it had none when it was the only one."""
    definition, told = rule.definition, {**rule.chances, "schedule": rule.schedule}
    if definition == SAND:
        return told
    if is_shipped(definition):
        return {"rule": definition.name, "digest": _digest(definition), **told}
    return {"rule": definition.name, "texts": list(definition.texts), **told}


def decode_rule(table):
    """Return the Rule that a CheckedTable spells out in full; raise TableError where it spells none."""
    definition = SAND
    if "texts" in table:
        definition = _own(table)
    elif "rule" in table:
        definition = load_definition(table.choice("rule", rule_names()))
        if table.values.get("digest") != _digest(definition):
            found = shown(table.values.get("digest"))
            raise table.error("digest", found, f"{_digest(definition)}: this {definition.name} is another")
    definition = definition.with_turned(tuple(table.values))
    names = [each.name for each in definition.chances]
    table.allow((*(() if definition == SAND else ("rule", "digest", "texts")), *names, "schedule"))
    numbers = {each.name: table.number(each.name, each) for each in definition.chances}
    schedule = table.choice("schedule", tuple(SCHEDULES))
    return _checked(table, lambda: Rule(definition=definition, schedule=schedule, **numbers))


def read_rule(table, folder):
    """Return the Rule that the key `rule` of a scene file says.

    It is the name of a shipped rule or of a file beside the scene, without .toml; or a table with that name, chances of
    its own, own numbers of materials ("water.spread" = 0.5) and a schedule. None if it is the sand's.
    """
    value = table.values.get("rule", {})
    if isinstance(value, str):
        value = {"name": value}
    if not isinstance(value, dict) or "name" not in value:
        return None
    given = type(table)(table.file, value, f"{table.where}rule.")
    rule = Rule(definition=_named(given, folder).with_turned(tuple(value)))
    given.allow(("name", *rule.chances, "schedule"))
    numbers = {each.name: given.number(each.name, each) for each in rule.definition.chances if each.name in given}
    schedule = given.choice("schedule", tuple(SCHEDULES), rule.schedule)
    return _checked(given, lambda: replace(rule, schedule=schedule, **numbers))


def _named(table, folder):
    name = table.line("name", "")
    beside = folder / f"{name}.toml"
    if name in rule_names():
        return load_definition(name)
    if not name or any(sign in name for sign in "/\\:") or not beside.is_file():
        wanted = f"one of {', '.join(rule_names())}, or the name of a rule file beside the scene, without .toml"
        raise table.error("name", shown(name), wanted)
    return load_definition(beside)


def _own(table):
    texts = table.values["texts"]
    good = isinstance(texts, list) and 1 <= len(texts) <= 1 + MOST_INCLUDES
    if not good or not all(isinstance(text, str) and len(text) <= LARGEST_FILE for text in texts):
        raise table.error("texts", shown(texts), "the texts of a rule file and of those that it includes")
    try:
        return definition_of_texts(table.line("rule", "rule")[:40], texts)
    except TableError as error:
        raise table.error("texts", f"no rule: {error}", "the texts of a rule") from None


def _checked(table, made):
    try:
        return made()
    except RuleError as error:  # chances of one event that are more than certain together
        place, found, wanted = error.told
        raise table.error(place, found, wanted) from None


def _digest(definition):
    """Return 16 hex digits that name what a rule says."""
    digest = hashlib.blake2b(digest_size=8)
    for text in definition.texts:
        digest.update(f"{len(text)} {text}".encode())
    return digest.hexdigest()
