"""What ends the program: an exit code, the same as the C++ program's, and one sentence."""

USAGE = 2
REPORT = 7


class Failure(Exception):
    def __init__(self, code, sentence):
        super().__init__(sentence)
        self.code = code
