package dev.eventchain.documentation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Inserts Java code into pages that the tests compile and run. */
final class JavaSnippets {

  /** Folder of the classes that pages show, from the project's root. */
  private static final String EXAMPLES =
      "bundles/documentation/src/test/java/dev/eventchain/documentation/examples/";

  private static final Pattern PLACE = Pattern.compile("(?m)^<!-- java (\\w+) -->$");

  private JavaSnippets() {}

  /** Returns the page with each reference to a class replaced by its code. */
  static String inserted(String page, Path root) throws IOException {
    StringBuilder text = new StringBuilder();
    Matcher place = PLACE.matcher(page);
    while (place.find()) {
      String code = Files.readString(root.resolve(EXAMPLES + place.group(1) + ".java"));
      place.appendReplacement(text, Matcher.quoteReplacement("```java\n" + shown(code) + "```"));
    }
    return place.appendTail(text).toString();
  }

  /** Returns the code that users need, without the package statement: the package is theirs. */
  private static String shown(String code) {
    return code.replaceFirst("(?s)^package [^;]+;\\s*", "");
  }
}
