package dev.eventchain.workspace.launch;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * State in which launch starts nodes. ROS 2 calls it the launch configurations: a scoped group
 * restores it, and an included file does not.
 */
final class LaunchScope {

  /** Value of a variable that is not known: it is never complete. */
  private static final String UNKNOWN = "$(unknown)";

  private static final int DEEPEST = 20;

  /** Greatest length of a value, and of what values add to a text. */
  private static final int LONGEST = 20_000;

  private static final Pattern VARIABLE = Pattern.compile("(?:var|arg)\\s+(\\S.*)", Pattern.DOTALL);

  private final Map<String, String> variables;

  /** Remappings for all later nodes, which apply before those of a node, the earliest first. */
  final List<TopicNames.Remap> remaps;

  /** Assignments to the parameters of all later nodes. */
  final List<ParameterAssignment> parameters;

  /** Begins with a slash; empty if it is not known. */
  Optional<String> namespace;

  LaunchScope() {
    this(Map.of(), List.of(), List.of(), Optional.of("/"));
  }

  private LaunchScope(
      Map<String, String> variables,
      List<TopicNames.Remap> remaps,
      List<ParameterAssignment> parameters,
      Optional<String> namespace) {
    this.variables = new HashMap<>(variables);
    this.remaps = new ArrayList<>(remaps);
    this.parameters = new ArrayList<>(parameters);
    this.namespace = namespace;
  }

  /** Returns the scope of a group, which keeps what it changes. */
  LaunchScope inner() {
    return new LaunchScope(variables, remaps, parameters, namespace);
  }

  /** Returns whether a group that began in a scope adds to remappings or parameters of that. */
  boolean addsTo(LaunchScope outer) {
    return (!outer.remaps.isEmpty() && remaps.size() > outer.remaps.size())
        || (!outer.parameters.isEmpty() && parameters.size() > outer.parameters.size());
  }

  boolean isSet(String variable) {
    return variables.containsKey(variable);
  }

  /** Sets a variable; one that is set to what is not known has no longer its earlier value. */
  void set(String variable, Optional<String> value) {
    variables.put(variable, value.filter(it -> it.length() <= LONGEST).orElse(UNKNOWN));
  }

  void unset(String variable) {
    variables.remove(variable);
  }

  /**
   * Adds assignments to the parameters of all later nodes.
   *
   * @param isSure whether they are made; otherwise, no value is known
   */
  void assign(List<ParameterAssignment> all, boolean isSure) {
    all.forEach(each -> parameters.add(isSure ? each : each.unsure()));
  }

  /** Returns whether a text has no substitution that is not known. */
  static boolean isComplete(String text) {
    return !text.contains("$(");
  }

  /** Returns the value of an attribute with its variables; empty if it is not known. */
  Optional<String> text(LaunchElement element, String attribute) {
    return path(element, attribute).filter(LaunchScope::isComplete);
  }

  /** Returns the value of an attribute likewise, which may begin with the folder of a package. */
  Optional<String> path(LaunchElement element, String attribute) {
    return element.known(attribute).flatMap(this::text);
  }

  /**
   * Returns a text with the values of its variables, {@code $(var NAME)} or {@code $(var NAME
   * DEFAULT)}; other substitutions stay. Empty if a variable has no value.
   */
  Optional<String> text(String written) {
    return text(written, 0);
  }

  private Optional<String> text(String written, int depth) {
    StringBuilder text = new StringBuilder();
    int at = 0;
    while (at < written.length()) {
      int start = written.indexOf("$(", at);
      int end = start < 0 ? -1 : end(written, start + 2);
      if (end < 0) {
        break;
      }
      text.append(written, at, start);
      Optional<String> value = substitution(written.substring(start + 2, end), depth);
      if (value.isEmpty() || text.length() + value.get().length() > start + LONGEST) {
        return Optional.empty();
      }
      text.append(value.get());
      at = end + 1;
    }
    return Optional.of(text.append(written.substring(at)).toString());
  }

  /** Returns where the parenthesis closes; -1 if it does not. */
  private static int end(String written, int start) {
    int open = 1;
    for (int i = start; i < written.length(); i++) {
      char each = written.charAt(i);
      open += each == '(' ? 1 : each == ')' ? -1 : 0;
      if (open == 0) {
        return i;
      }
    }
    return -1;
  }

  private Optional<String> substitution(String inner, int depth) {
    if (LaunchSubstitution.isOne(inner.split("\\s", 2)[0]) && depth <= DEEPEST) {
      return LaunchSubstitution.value(inner, word -> text(word, depth + 1));
    }
    Matcher variable = VARIABLE.matcher(inner);
    if (!variable.matches() || depth > DEEPEST) {
      return Optional.of("$(" + inner + ")");
    }
    String all = variable.group(1);
    int end = endOfName(all);
    Optional<String> name = text(unquoted(all.substring(0, end)), depth + 1);
    if (!name.filter(LaunchScope::isComplete).isPresent()) {
      return Optional.of(UNKNOWN);
    }
    String value = variables.get(name.get());
    String usual = all.substring(end).strip();
    return value != null || usual.isEmpty()
        ? Optional.ofNullable(value)
        : text(unquoted(usual), depth + 1);
  }

  /** Returns where a name ends, which may have substitutions in parentheses. */
  private static int endOfName(String text) {
    int end = 0;
    while (end < text.length() && !Character.isWhitespace(text.charAt(end))) {
      int close = text.startsWith("$(", end) ? end(text, end + 2) : -1;
      end = close < 0 ? end + 1 : close + 1;
    }
    return end;
  }

  private static String unquoted(String text) {
    boolean isQuoted = text.length() > 1 && text.startsWith("'") && text.endsWith("'");
    return isQuoted ? text.substring(1, text.length() - 1) : text;
  }
}
