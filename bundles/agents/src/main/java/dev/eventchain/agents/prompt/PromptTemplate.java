package dev.eventchain.agents.prompt;

import dev.eventchain.diagnostics.ResourceText;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A prompt with placeholders, {@code {{name}}}. Lines that begin with {@code %%} are comments and
 * are not sent. Values are inserted verbatim: braces and comments inside a value have no meaning.
 */
public final class PromptTemplate {
  private static final String FOLDER = "/dev/eventchain/agents/prompts/";
  private static final Pattern PLACE = Pattern.compile("\\{\\{([^{}\\n]+)}}");

  private final String name;
  private final String text;

  private PromptTemplate(String name, String text) {
    this.name = name;
    this.text = text;
  }

  public static PromptTemplate of(String name, String text) {
    String sent =
        text.replace("\r\n", "\n")
            .lines()
            .filter(line -> !line.startsWith("%%"))
            .collect(Collectors.joining("\n"));
    return new PromptTemplate(name, sent);
  }

  /** Loads {@code prompts/NAME.md}, for example {@code design/v1}. */
  public static PromptTemplate load(String name) {
    return of(name, resource(name + ".md"));
  }

  /** Returns the text of a file below {@code prompts/}. */
  public static String resource(String path) {
    return ResourceText.of(PromptTemplate.class, FOLDER + path);
  }

  /** Returns the prompt's name, which includes its version. */
  public String name() {
    return name;
  }

  /**
   * Fills every placeholder.
   *
   * @throws IllegalArgumentException if a placeholder has no value, or a value has no placeholder
   */
  public String render(Map<String, String> values) {
    Set<String> places =
        PLACE.matcher(text).results().map(place -> place.group(1)).collect(Collectors.toSet());
    if (!places.equals(values.keySet())) {
      throw new IllegalArgumentException(
          "prompt %s has the places %s, but was given %s"
              .formatted(name, new TreeSet<>(places), new TreeSet<>(values.keySet())));
    }
    return PLACE.matcher(text).replaceAll(place -> Matcher.quoteReplacement(value(place, values)));
  }

  // A text file ends with a line break, but a value inside a prompt does not.
  private static String value(MatchResult place, Map<String, String> values) {
    return values.get(place.group(1)).replace("\r\n", "\n").stripTrailing();
  }
}
