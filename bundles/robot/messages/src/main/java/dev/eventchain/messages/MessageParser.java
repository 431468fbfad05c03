package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
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
 * Parser for the message language of ROS 2 (docs.ros.org, "About ROS 2 interfaces"): one field or
 * constant per line. It continues after an invalid line.
 */
final class MessageParser {

  /** Line separators of Python, whose rules rosidl_adapter follows. */
  private static final Pattern LINE_END =
      Pattern.compile("[\n\r\u000b\f\u001c-\u001e\u0085\u2028\u2029]");

  private static final Pattern LINE = Pattern.compile("\\s*(?<type>\\S+)\\s*(?<rest>.*?)\\s*");
  private static final Pattern CONSTANT =
      Pattern.compile("(?<name>[A-Za-z]\\w*)\\s*=\\s*(?<value>.*)");
  private static final Pattern FIELD =
      Pattern.compile("(?<name>[A-Za-z]\\w*)(\\s+(?<value>\\S[^=]*))?");
  private static final Pattern TYPE =
      Pattern.compile(
          "(?<base>[A-Za-z][\\w/]*)(<=(?<string>0*[1-9]\\d{0,8}))?"
              + "(?<array>\\[((?<bound><=)?(?<size>0*[1-9]\\d{0,8}))?\\])?");
  private static final String GRAMMAR =
      "A line is TYPE NAME, TYPE NAME DEFAULT or TYPE NAME=VALUE, as in: float64[<=9] values";
  private static final String WIDE = "wstring";
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
   * Parses one definition.
   *
   * @param name the full name of the type
   */
  static Definition parse(String name, SourceText source) {
    return parse(name, source, 0, source.text().length());
  }

  /** Parses a definition that is between two places of a text. */
  static Definition parse(String name, SourceText source, int begin, int end) {
    MessageParser parser = new MessageParser(name, source);
    parser.readLines(begin, end);
    return new Definition(name, parser.fields, parser.constants, parser.problems);
  }

  /** Returns the full name for {@code Header}, {@code Vector3} or {@code geometry_msgs/Vector3}. */
  static String fullName(String text, String ownPackage) {
    if (text.equals("Header")) {
      return HEADER;
    }
    return text.indexOf('/') < 0 ? ownPackage + "/msg/" + text : RosNames.fullMessageType(text);
  }

  private void readLines(int begin, int last) {
    String text = source.text().substring(0, last);
    Matcher newline = LINE_END.matcher(text);
    for (int start = begin, end; start < text.length(); start = end + 1) {
      end = newline.find(start) ? newline.start() : text.length();
      String line = text.substring(start, end);
      String code = line.substring(0, line.indexOf('#') < 0 ? line.length() : line.indexOf('#'));
      if (!code.isBlank()) {
        readLine(code, start);
      }
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
      String found = rest.contains("=") ? rest.substring(0, rest.indexOf('=')).strip() : rest;
      String wrong = found.isEmpty() ? "a name is missing" : "'" + found + "' is not a name";
      syntaxProblem("After the type, " + wrong + ".", restOffset);
    }
  }

  private void add(List<Member> members, Matcher found, Member typed, int offset) {
    String member = found.group("name");
    boolean isConstant = members == constants;
    SourceLocation place = source.at(offset);
    if (!names.add(member)) {
      String message = "'" + member + "' is defined twice.";
      problems.add(Diagnostic.of(MessageRules.NAME_DUPLICATE, message, place));
      return;
    }
    Object value = null;
    String text = found.group("value");
    if (text != null || isConstant) {
      try {
        value = Literals.parse(typed.type(), text, isConstant);
      } catch (IllegalArgumentException e) {
        SourceLocation ofValue = source.at(offset + Math.max(0, found.start("value")));
        problems.add(Diagnostic.of(MessageRules.VALUE, String.valueOf(e.getMessage()), ofValue));
        return;
      }
    }
    Optional<Diagnostic> problem =
        isConstant
            ? MemberNames.problemOfConstant(member, place)
            : MemberNames.problemOfField(member, place);
    problem.ifPresent(problems::add);
    members.add(new Member(member, typed.type(), typed.base(), value, typed.place()));
  }

  private static Diagnostic wide(SourceLocation place) {
    return Diagnostic.of(MessageRules.SYNTAX, "wstring is not supported.", place)
        .withHint("Use string: implementations of DDS encode wstring unequally.");
  }

  /** Parses a type into a member without a name. */
  private Optional<Member> type(String text, int offset) {
    Matcher type = TYPE.matcher(text);
    boolean isType = type.matches();
    String base = isType ? type.group("base") : "";
    if (base.equals(WIDE)) {
      problems.add(wide(source.at(offset)));
      return Optional.empty();
    }
    FieldType.Kind kind = kind(base);
    String fullName = kind == FieldType.Kind.MESSAGE ? fullName(base, packageName()) : base;
    boolean unknown = kind == FieldType.Kind.MESSAGE && !RosNames.isFullMessageType(fullName);
    boolean isBounded = isType && type.group("string") != null;
    if (!isType || unknown || (isBounded && kind != FieldType.Kind.STRING)) {
      syntaxProblem("'" + text + "' is not a type.", offset);
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

  private void syntaxProblem(String message, int offset) {
    Diagnostic problem = Diagnostic.of(MessageRules.SYNTAX, message, source.at(offset));
    problems.add(problem.withHint(GRAMMAR));
  }
}
