package dev.eventchain.lsp.action;

import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.TextFix;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Changes that findings propose, as edits of JSON and YAML at the place of the value. Nothing is
 * changed if the text is not as the finding says.
 */
final class DocumentChanges {

  /** The key of the quality of service of a topic, which is a child of data in models. */
  private static final String QOS = "qos_profile";

  private static final String TOPIC = "topic";

  /** Names of profiles; with other ones, case and prefixes do not matter. */
  private static final Pattern PROFILE = Pattern.compile("(?!rmw_|qos_profile_)[a-z]+(?:_[a-z]+)*");

  /** Short for the default profile with this reliability. */
  private static final Pattern RELIABILITY = Pattern.compile("reliable|best_effort");

  /** A scalar in YAML: quoted, or plain up to its end. */
  private static final Pattern SCALAR =
      Pattern.compile("\"([^\"\\\\\\n]*)\"|'([^'\\n]*)'|([^\\s'\"\\[{][^\\n,\\]}#]*)");

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z][\\w/^*. -]*");

  private DocumentChanges() {}

  /** Returns a change of the value that begins at an offset of a text in YAML. */
  static Optional<TextFix> yaml(String text, int offset, ModelChange change) {
    Matcher scalar = SCALAR.matcher(text).region(offset, text.length());
    if (!change.child().isEmpty() || !scalar.lookingAt()) {
      return Optional.empty();
    }
    int group = scalar.group(1) != null ? 1 : scalar.group(2) != null ? 2 : 3;
    String written = scalar.group(group).strip();
    String by = change.to();
    boolean needsQuotes = group == 3 && !PLAIN.matcher(by).matches();
    return written.equals(change.from()) && by.matches("[^'\"\\\\\\r\\n]*")
        ? Optional.of(
            new TextFix(
                scalar.start(group),
                scalar.start(group) + scalar.group(group).stripTrailing().length(),
                needsQuotes ? quoted(by) : by))
        : Optional.empty();
  }

  /** As above, in JSON; the change of a profile may be at the topic that has none. */
  static Optional<TextFix> json(String text, int offset, ModelChange change) {
    Optional<JsonSpan> value = JsonSpan.at(text, offset);
    return change.child().isEmpty()
        ? value
            .filter(it -> it.isString() && it.scalar().equals(Optional.of(change.from())))
            .map(it -> new TextFix(it.start(), it.end(), quoted(change.to())))
        : value.flatMap(it -> policy(text, it, change.attribute(), change.to()));
  }

  /** Returns the change of a policy in a profile. */
  private static Optional<TextFix> policy(String text, JsonSpan at, String policy, String to) {
    if (at.scalar().isPresent()) {
      return named(at, policy, to).map(by -> new TextFix(at.start(), at.end(), by));
    }
    Map<String, JsonSpan> members = at.members();
    if (members.containsKey(TOPIC) && !members.containsKey(QOS)) {
      return Optional.of(added(text, at, quoted(QOS) + ": {" + member(policy, to) + "}"));
    } else if (members.containsKey(TOPIC) || text.charAt(at.start()) != '{') {
      return Optional.empty();
    }
    JsonSpan present = members.get(policy);
    return Optional.of(
        present == null
            ? added(text, at, member(policy, to))
            : new TextFix(present.start(), present.end(), quoted(to)));
  }

  /** Returns the profile with a policy instead of one that is only named. */
  private static Optional<String> named(JsonSpan at, String policy, String to) {
    String written = at.scalar().orElseThrow();
    boolean isReliability = RELIABILITY.matcher(written).matches();
    if (!at.isString() && written.matches("[0-9]+")) {
      return Optional.of("{\"depth\": " + written + ", " + member(policy, to) + "}");
    } else if (isReliability && policy.equals("reliability")) {
      return Optional.of("{" + member(policy, to) + "}");
    }
    return at.isString() && !isReliability && PROFILE.matcher(written).matches()
        ? Optional.of("{" + member("profile", written) + ", " + member(policy, to) + "}")
        : Optional.empty();
  }

  /** Returns a member as the first one of an object, with the white space of the present one. */
  private static TextFix added(String text, JsonSpan object, String member) {
    int inside = object.start() + 1;
    int next = inside;
    while (next < text.length() && Character.isWhitespace(text.charAt(next))) {
      next++;
    }
    String rest = object.members().isEmpty() ? "" : ",";
    String gap = text.substring(inside, next);
    String before = object.members().isEmpty() ? "" : gap;
    String after = object.members().isEmpty() || !gap.isEmpty() ? "" : " ";
    return new TextFix(inside, inside, before + member + rest + after);
  }

  private static String member(String name, String value) {
    return quoted(name) + ": " + quoted(value);
  }

  private static String quoted(String value) {
    return '"' + value.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
