"""Tells what differs, and which differences are wanted."""
import fnmatch


class Intended:
    """Differences that are wanted: lines `PATTERN => REASON`. Lines that begin with # are remarks.

    A pattern fits a command, or `COMMAND: ITEM`, as they are told, with * and ? as in a shell.
    """

    def __init__(self, file):
        self.reasons = {}
        self.used = set()
        lines = file.read_text(encoding='utf-8').split('\n') if file.exists() else []
        for number, line in enumerate(lines, 1):
            if not line.strip() or line.startswith('#'):
                continue
            pattern, arrow, reason = line.partition(' => ')
            if not arrow or not reason.strip():
                raise ValueError(f'{file}:{number}: write PATTERN => REASON')
            self.reasons[pattern.strip()] = reason.strip()

    def reason(self, difference):
        """Why it is wanted; None where it is not."""
        texts = (difference.command, f'{difference.command}: {difference.item}')
        for pattern, reason in self.reasons.items():
            if any(fits(text, pattern) for text in texts):
                self.used.add(pattern)
                return reason
        return None

    def stale(self):
        return [pattern for pattern in self.reasons if pattern not in self.used]


def fits(text, pattern):
    """Only * and ? are special: commands have brackets of their own."""
    return fnmatch.fnmatchcase(text, pattern.replace('[', '[[]'))


class Report:
    def __init__(self, intended):
        self.intended = intended
        self.same = self.different = self.wanted = 0
        self.left_out = {}

    def add(self, commands, differences):
        """So many commands were run by both."""
        bad = set()
        good = set()
        last = None
        for difference in differences:
            reason = self.intended.reason(difference)
            (good if reason else bad).add(difference.command)
            if difference.command != last:
                print(f'{difference.room}: {difference.command}')
                last = difference.command
            print(f'  {difference.item}{f", intended: {reason}" if reason else ""}: {difference.told[0]}')
            for line in difference.told[1:]:
                print(f'    {line}')
        if differences:
            print(flush=True)
        self.different += len(bad)
        self.wanted += len(good - bad)
        self.same += commands - len(bad | good)

    def leave_out(self, reason, commands=1):
        self.left_out[reason] = self.left_out.get(reason, 0) + commands

    def finish(self, tells_stale):
        """The last lines; whether all is well."""
        for reason, commands in sorted(self.left_out.items()):
            print(f'left out: {reason}' + (f' ({commands} commands)' if commands > 1 else ''))
        if tells_stale:
            for pattern in self.intended.stale():
                print(f'stale: intended.txt has "{pattern}", which no difference fits')
        print(f'{self.same} the same, {self.different} different, {self.wanted} intended, '
              f'{sum(self.left_out.values())} left out')
        return self.different == 0
