"""What differs between two outcomes, in few words."""
import dataclasses

NEVER_FAIL = ('faces', 'view')  # what fails there compares nothing
LONGEST = 160  # of a line that is told


@dataclasses.dataclass
class Difference:
    room: str
    command: str
    item: str    # exit code, standard error, standard output, or a file
    told: list   # lines


def differences(room, before, after):
    """before, after: a list of (command, {item: bytes}) each, of the same commands."""
    found = []
    for (command, old), (_, new) in zip(before, after):
        for item in [*old, *(item for item in new if item not in old)]:
            if old.get(item) != new.get(item):
                found.append(Difference(room, command, item, told(old.get(item), new.get(item))))
        if room in NEVER_FAIL and old['exit code'] == new['exit code'] != b'0':
            last = new['standard error'].strip().split(b'\n')[-1]
            found.append(Difference(room, command, 'exit code', [f'{shown(new["exit code"])} by both: {shown(last)}']))
    return found


def told(old, new):
    if old is None or new is None:
        return [f'written by {"AFTER" if old is None else "BEFORE"} alone']
    lines = [data.split(b'\n') for data in (old, new)]
    if all(is_text(data) for data in (old, new)):
        number, first = first_difference(*lines)
        return [f'line {number + 1}:', f'- {shown(first[0])}', f'+ {shown(first[1])}']
    place, _ = first_difference(old, new)
    sizes = f'{len(old)} bytes' if len(old) == len(new) else f'{len(old)} and {len(new)} bytes'
    words = [f'{sizes}, first difference at byte {place}']
    number, first = first_difference(*lines)
    if all(line is not None and is_text(line) for line in first):  # as in the XML before a file's data
        words += [f'- {shown(first[0])}', f'+ {shown(first[1])}']
    return words


def first_difference(old, new):
    """The place, and what is there; None behind an end."""
    for place, pair in enumerate(zip(old, new)):
        if pair[0] != pair[1]:
            return place, pair
    place = min(len(old), len(new))
    return place, tuple(each[place] if place < len(each) else None for each in (old, new))


def is_text(data):
    try:
        data.decode('utf-8')
    except UnicodeDecodeError:
        return False
    return b'\0' not in data


def shown(line):
    if line is None:
        return '(no such line)'
    text = line.decode('utf-8', 'replace').replace('\t', ' ').strip()
    return text if len(text) <= LONGEST else text[:LONGEST] + ' ...'
