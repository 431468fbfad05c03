package dev.eventchain.agents;

import static dev.eventchain.agents.JsonMutations.replaced;
import static dev.eventchain.agents.Mutation.rejected;
import static dev.eventchain.agents.Mutation.visible;

import dev.eventchain.agents.Mutation.Change;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;

/** Mutations of Python components. */
final class PythonMutations {
  private static final String CLASS = "(?m)^class ";
  private static final String BODY = "(?m)^ {8}return \\{\"";
  private static final List<String> IMPORTS =
      List.of(
          "rclpy",
          "os",
          "subprocess",
          "socket",
          "requests",
          "time",
          "random",
          "ttc_utils",
          "threading",
          "pathlib");
  private static final List<String> CALLS =
      List.of(
          "eval('1')",
          "open('/tmp/x')",
          "exec('x = 1')",
          "__import__('os')",
          "globals()",
          "getattr(self, str(1))",
          "input()");

  private PythonMutations() {}

  static List<Mutation> all() {
    return List.of(
        rejected(
            "a forbidden import",
            replaced(
                Pattern.compile(CLASS),
                (found, random) -> "import " + any(IMPORTS, random) + "\n\n\n" + found)),
        rejected(
            "a forbidden import inside",
            replaced(
                Pattern.compile(BODY),
                (found, random) -> "        import " + any(IMPORTS, random) + "\n" + found)),
        rejected(
            "a forbidden call",
            replaced(
                Pattern.compile(BODY),
                (found, random) -> "        " + any(CALLS, random) + "\n" + found)),
        rejected(
            "another class", in("(?<=class )\\w+(?=:)(?!.*\\nclass )", found -> found + "Node")),
        rejected("another method", in("(?<=def )execute", found -> "run")),
        rejected("another argument", in("(?<=def execute\\(self, )\\w+", found -> found + "_x")),
        rejected("an argument more", in("(?<=def execute\\()self, ", found -> "self, dt, ")),
        rejected("another key", in("(?<=return \\{\")\\w+", found -> found + "_x")),
        rejected("no dict", reached(in("(?<=return )\\{\"", found -> "1.0 or {\""))),
        rejected("work at import", in(CLASS, found -> "print('here')\n\n\n" + found)),
        rejected("no colon", in("(?<=def execute\\([^)]{1,200}\\)):", found -> "")),
        rejected("a bracket too many", in("(?<=return \\{\")", found -> "a\": (\"")),
        rejected("prose in the block", in(CLASS, found -> "This is the class.\n" + found)),
        rejected(
            "not a number", reached(in("(?<=\\w\": )(?=[\\w(-])", found -> "float('nan') + "))),
        rejected("raises", reached(in(BODY, found -> "        raise ValueError('no')\n" + found))),
        rejected(
            "state in a global",
            in(BODY, found -> "        global _calls\n        _calls += 1\n" + found)),
        visible("another comment", in(CLASS, found -> "# Changed.\n" + found)),
        visible("a constant more", in(CLASS, found -> "UNUSED = 1.0\n\n\n" + found)),
        visible("another docstring", in("\"\"\"(?=[A-Z])", found -> found + "Changed: ")));
  }

  /**
   * Restricts a mutation that only a call reveals to code that is certainly called. In a component
   * with state, a fault after some calls with certain values may stay undetected.
   */
  private static Change reached(Change change) {
    return (answer, random) ->
        answer.text().contains("self._") ? Optional.empty() : change.of(answer, random);
  }

  private static String any(List<String> list, Random random) {
    return list.get(random.nextInt(list.size()));
  }

  private static Change in(String regex, UnaryOperator<String> by) {
    return replaced(Pattern.compile(regex), (found, random) -> by.apply(found));
  }
}
