"""Runs check.py on a folder of its own: what it counts, what it refuses, and that limits only go down."""
import os
import subprocess
import sys
import tempfile
import unittest

CHECK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "check.py")
PLAIN = "// Returns the distance from the point to the plane, in mm.\nint f();\n"
ELLIPTIC = "// Of those the one that nobody knows, beside what others told.\nint f();\n"


class Check(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.git("init", "-q")
        self.write("tests/language/limits.txt", "")

    def git(self, *words):
        subprocess.run(["git", "-C", self.folder.name, "-c", "user.name=n", "-c", "user.email=e", *words],
                       check=True, capture_output=True)

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)

    def check(self, *options):
        run = subprocess.run([sys.executable, CHECK, self.folder.name, *options], capture_output=True, text=True)
        return run.returncode, run.stderr

    def test_plain_comments_pass(self):
        self.write("lib/a/a.cpp", PLAIN)
        self.assertEqual(self.check(), (0, ""))

    def test_each_figure_of_a_comment_is_refused(self):
        self.write("lib/a/a.cpp", ELLIPTIC)
        code, errors = self.check()
        self.assertEqual(code, 1)
        for figure in ("pronouns", "starts", "words"):
            self.assertIn("lib/a: " + figure, errors)

    def test_messages_are_counted(self):
        self.write("lib/a/a.cpp", PLAIN + 'const char* kText = "nobody told the length";\n')
        self.assertIn("lib/a: words 2", self.check()[1])

    def test_long_sentences_of_docs_are_refused(self):
        self.write("docs/a.md", "A sentence " + "with many words " * 9 + "ends here.\n")
        self.assertIn("docs/*.md: long", self.check()[1])
        self.write("docs/a.md", "| a table " + "with many words " * 9 + "|\n")
        self.assertEqual(self.check()[0], 0)

    def test_limits_let_old_folders_pass_and_only_go_down(self):
        self.write("lib/a/a.cpp", ELLIPTIC)
        self.check("--lower")
        self.assertEqual(self.check()[0], 0)
        self.git("add", ".")
        self.git("commit", "-qm", "x")
        self.write("lib/a/a.cpp", PLAIN)
        self.check("--lower")
        self.write("lib/a/a.cpp", ELLIPTIC)
        self.assertEqual(self.check()[0], 1)
        self.write("tests/language/limits.txt", "lib/a 99.0 99.0 99 0.0\n")
        self.assertIn("went up", self.check()[1])

    def test_new_folders_keep_to_the_bar(self):
        self.write("lib/a/a.cpp", ELLIPTIC)
        self.check("--lower")
        self.write("lib/b/b.cpp", ELLIPTIC)
        self.check("--lower")
        self.assertIn("lib/b: pronouns", self.check()[1])


if __name__ == "__main__":
    unittest.main()
