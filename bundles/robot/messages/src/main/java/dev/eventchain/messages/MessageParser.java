package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.Definition.Member;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads the message language of ROS 2 (docs.ros.org, "About ROS 2 interfaces"): a field or a
 * constant a line, and continues after a line that is wrong.
 */
final class MessageParser {

  private static final Pattern LINE = Pattern.compile("\\s*(?<type>\\S+)\\s*(?<rest>.*?)\\s*");
  private static final Pattern CONSTANT =
      Pattern.compile("(?<name>[A-Za-z]\\w*)\\s*=\\s*(?<value>.*)");
  private static final Pattern FIELD =
      Pattern.compile("(?<name>[A-Za-z]\\w*)(\\s+(?<value>[^=\\s].*))?");
  private static final Pattern TYPE =
      Pattern.compile(
          "(?<base>[A-Za-z][\\w/]*)(<=(?<string>\\d{1,9}))?"
              + "(?<array>\\[((?<bound><=)?(?<size>\\d{1,9}))?\\])?");
  private static final String GRAMMAR =
      "A line is TYPE NAME, TYPE NAME DEFAULT or TYPE NAME=VALUE, as in: float64[<=9] values";
  private static final String HEADER = "std_msgs/msg/Header";

  private final String name;
  private final SourceText source;
  private final List<Member> fields = new ArrayList<>();
  private final List<Member> constants = new ArrayList<>();
  private final List<Diagnostic> problems = new ArrayList<>();
  private final Set<String> names = new HashSet<>();

  private MessageParser(String name, SourceText source) {
    this.name = name;
    this.source = source;
  }

  /**
   * Reads one definition.
   *
   * @param name the full name of the type
   */
  static Definition parse(String name, SourceText source) {
    MessageParser parser = new MessageParser(name, source);
    parser.readLines();
    return new Definition(name, parser.fields, parser.constants, parser.problems);
  }

  /** {@code Header}, {@code Vector3}, {@code geometry_msgs/Vector3} as full names. */
  static String fullName(String text, String ownPackage) {
    if (text.equals("Header")) {
      return HEADER;
    }
    return text.indexOf('/') < 0 ? ownPackage + "/msg/" + text : RosNames.fullMessageType(text);
  }

  private void readLines() {
    String text = source.text();
    int start = 0;
    while (start < text.length()) {
      int newline = text.indexOf('\n', start);
      int end = newline < 0 ? text.length() : newline;
      int comment = text.indexOf('#', start);
      String code = text.substring(start, comment >= 0 && comment < end ? comment : end);
      if (!code.isBlank()) {
        readLine(code, start);
      }
      start = end + 1;
    }
  }

  private void readLine(String code, int offset) {
    Matcher line = LINE.matcher(code);
    if (!line.matches()) {
      return; // a line that is not blank has a first word
    }
    int typeOffset = offset + line.start("type");
    Optional<Member> typed = type(line.group("type"), typeOffset);
    String rest = line.group("rest");
    int restOffset = offset + line.start("rest");
    if (typed.isEmpty()) {
      return;
    }
    Matcher constant = CONSTANT.matcher(rest);
    Matcher field = FIELD.matcher(rest);
    if (constant.matches()) {
      add(constants, constant, typed.get(), restOffset);
    } else if (field.matches()) {
      add(fields, field, typed.get(), restOffset);
    } else {
      String found = rest.isEmpty() ? "a name is missing" : "'" + rest + "' is not a name";
      problem("message.syntax", "After the type, " + found + ".", restOffset);
    }
  }

  private void add(List<Member> members, Matcher found, Member typed, int offset) {
    String member = found.group("name");
    if (!names.add(member)) {
      problem("message.name.duplicate", "'" + member + "' is defined twice.", offset);
      return;
    }
    Object value = null;
    String text = found.group("value");
    if (text != null || members == constants) {
      try {
        value = Literals.parse(typed.type(), text, members == constants);
      } catch (IllegalArgumentException e) {
        int place = offset + Math.max(0, found.start("value"));
        problem("message.value", String.valueOf(e.getMessage()), place);
        return;
      }
    }
    members.add(new Member(member, typed.type(), typed.base(), value, typed.place()));
  }

  /** A member without name: its type, and the base of that. */
  private Optional<Member> type(String text, int offset) {
    Matcher type = TYPE.matcher(text);
    if (!type.matches()) {
      problem("message.syntax", "'" + text + "' is not a type.", offset);
      return Optional.empty();
    }
    String base = type.group("base");
    FieldType.Kind kind = kind(base);
    String fullName = kind == FieldType.Kind.MESSAGE ? fullName(base, packageName()) : base;
    boolean isText = kind == FieldType.Kind.STRING || kind == FieldType.Kind.WSTRING;
    boolean unknown = kind == FieldType.Kind.MESSAGE && !RosNames.isFullMessageType(fullName);
    if (unknown || (type.group("string") != null && !isText)) {
      problem("message.syntax", "'" + text + "' is not a type.", offset);
      return Optional.empty();
    }
    FieldType.Shape shape = FieldType.Shape.SINGLE;
    if (type.group("array") != null) {
      boolean fixed = type.group("size") != null && type.group("bound") == null;
      shape = fixed ? FieldType.Shape.ARRAY : FieldType.Shape.SEQUENCE;
    }
    FieldType result =
        new FieldType(
            kind,
            Optional.empty(),
            shape,
            number(type.group("size")),
            number(type.group("string")));
    return Optional.of(new Member("", result, fullName, null, source.at(offset)));
  }

  private String packageName() {
    return name.substring(0, name.indexOf('/'));
  }

  private static int number(String digits) {
    return digits == null ? 0 : Integer.parseInt(digits);
  }

  private static FieldType.Kind kind(String base) {
    boolean isLower = base.equals(base.toLowerCase(Locale.ROOT)) && !base.equals("message");
    for (FieldType.Kind kind : FieldType.Kind.values()) {
      if (isLower && kind.name().toLowerCase(Locale.ROOT).equals(base)) {
        return kind;
      }
    }
    return FieldType.Kind.MESSAGE;
  }

  private void problem(String id, String message, int offset) {
    Diagnostic problem = Diagnostic.error(id, message, source.at(offset));
    boolean syntax = id.equals("message.syntax");
    problems.add(syntax ? problem.withHint(GRAMMAR) : problem);
  }
}
