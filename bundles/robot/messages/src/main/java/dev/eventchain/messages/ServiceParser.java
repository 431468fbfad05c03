package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reader of {@code .srv} files, which define a request and a response in the language of messages,
 * with a line {@code ---} between them. For ROS 2, they are the message types {@code NAME_Request}
 * and {@code NAME_Response} of the service's package.
 */
final class ServiceParser {

  /** The end of a file's name. */
  static final String SUFFIX = ".srv";

  private static final String REQUEST = "_Request";
  private static final String RESPONSE = "_Response";
  private static final Pattern SEPARATOR = Pattern.compile("(?m)^---[ \\t]*\\r?$");
  private static final Pattern SERVICE =
      Pattern.compile("[a-z][a-z0-9]*(_[a-z0-9]+)*/srv/[A-Z][A-Za-z0-9]*");

  private ServiceParser() {}

  /** Returns the names of both message types of the service {@code std_srvs/srv/SetBool}. */
  static List<String> messages(String service) {
    return List.of(service + REQUEST, service + RESPONSE);
  }

  /** Returns the service of one of its message types. */
  static String serviceOf(String message) {
    String end = message.endsWith(REQUEST) ? REQUEST : RESPONSE;
    return message.substring(0, message.length() - end.length());
  }

  /** Returns whether a text is the full name of a service type. */
  static boolean isService(String name) {
    return SERVICE.matcher(name).matches();
  }

  /**
   * Parses one of the two definitions of a file.
   *
   * @param name the full name of the message type
   */
  static Definition parse(String name, SourceText source) {
    List<Integer> bounds = new ArrayList<>();
    bounds.add(0);
    Matcher separator = SEPARATOR.matcher(source.text());
    while (separator.find()) {
      bounds.add(separator.start());
      bounds.add(separator.end());
    }
    bounds.add(source.text().length());
    if (bounds.size() != 4) {
      return new Definition(name, List.of(), List.of(), List.of(separators(source, bounds)));
    }
    int half = name.endsWith(RESPONSE) ? 2 : 0;
    return MessageParser.parse(name, source, bounds.get(half), bounds.get(half + 1));
  }

  private static Diagnostic separators(SourceText source, List<Integer> bounds) {
    boolean isAction = bounds.size() > 4;
    int offset = isAction ? bounds.get(3) : 0;
    String message =
        isAction
            ? "A second line '---' is in this definition of a service."
            : "The line '---' between request and response is missing.";
    return Diagnostic.of(MessageRules.SYNTAX, message, source.at(offset))
        .withHint("A service is a request, a line ---, and a response; each may be empty.");
  }
}
