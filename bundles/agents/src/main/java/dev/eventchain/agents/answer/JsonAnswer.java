package dev.eventchain.agents.answer;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.cfg.JsonNodeFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.JsonLayout;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * JSON in an answer. Trailing commas, single quotes, comments and the constants of Python are
 * accepted, and the result is written in one layout.
 */
final class JsonAnswer {
  private static final JsonMapper TOLERANT =
      JsonMapper.builder(
              JsonFactory.builder()
                  .streamReadConstraints(
                      StreamReadConstraints.builder().maxNestingDepth(Document.DEEPEST).build())
                  .build())
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_TRAILING_COMMA)
          .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
          .enable(JsonReadFeature.ALLOW_YAML_COMMENTS)
          .enable(JsonReadFeature.ALLOW_SINGLE_QUOTES)
          .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
          .disable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .configure(JsonNodeFeature.STRIP_TRAILING_BIGDECIMAL_ZEROES, false)
          .build();
  private static final DocumentRules RULES = DocumentRules.all(AnswerFormRules.ANSWER_JSON);
  private static final List<String> WORDS =
      List.of("true", "false", "null", "True", "False", "None");
  private static final Pattern UNKNOWN_WORD = Pattern.compile("Unrecognized token '(\\w+)'");
  private static final Pattern START = Pattern.compile("(?m)^[ \\t]*[\\[{]");
  private static final Pattern START_IN_LINE = Pattern.compile("[\\[{]\\s*[\\[{\"']");

  private JsonAnswer() {}

  /** Returns the only JSON array or object in a text without fences. */
  static AnswerText search(String file, String text) {
    OptionalInt start = start(text);
    if (start.isEmpty()) {
      return AnswerText.nothing(AnswerKind.JSON, file);
    }
    String rest = PythonWords.replaced(text.substring(start.getAsInt()).stripTrailing());
    try (JsonParser parser = TOLERANT.createParser(rest)) {
      JsonNode node = TOLERANT.readTree(parser);
      int end = (int) parser.currentLocation().getCharOffset();
      return holdsAnother(rest.substring(end))
          ? AnswerText.several(AnswerKind.JSON, file, 2)
          : found(file, node);
    } catch (IOException e) {
      return broken(file, rest, e);
    } catch (NumberFormatException e) {
      return number(file);
    }
  }

  /** Returns the likely start of an array or object, preferably at the beginning of a line. */
  private static OptionalInt start(String text) {
    for (Pattern pattern : List.of(START, START_IN_LINE)) {
      Matcher start = pattern.matcher(text);
      if (start.find()) {
        return OptionalInt.of(start.start());
      }
    }
    return OptionalInt.empty();
  }

  private static boolean holdsAnother(String text) {
    OptionalInt start = start(text);
    if (start.isEmpty()) {
      return false;
    }
    try (JsonParser parser = TOLERANT.createParser(text.substring(start.getAsInt()))) {
      return TOLERANT.readTree(parser) != null;
    } catch (IOException | NumberFormatException e) {
      return false;
    }
  }

  /** Parses a text that consists of JSON only. */
  static AnswerText parse(String file, String block) {
    String text = PythonWords.replaced(block);
    try {
      JsonNode node =
          TOLERANT.reader().with(DeserializationFeature.FAIL_ON_TRAILING_TOKENS).readTree(text);
      return node.isContainerNode() ? found(file, node) : AnswerText.nothing(AnswerKind.JSON, file);
    } catch (IOException e) {
      return broken(file, text, e);
    } catch (NumberFormatException e) {
      return number(file);
    }
  }

  /**
   * Returns the JSON in one layout, unless it has a text that cannot be displayed or stored in a
   * file.
   */
  private static AnswerText found(String file, JsonNode node) {
    AnswerText found = AnswerText.found(file, JsonLayout.of(node));
    List<Diagnostic> problems = new ArrayList<>();
    Document.parse(found.artefact().orElseThrow(), DocumentFormat.JSON, RULES, problems::add);
    return problems.isEmpty() ? found : new AnswerText(Optional.empty(), problems);
  }

  /**
   * Returns the problem of a number whose exponent is out of range; the parser accepts such
   * exponents.
   */
  private static AnswerText number(String file) {
    return AnswerText.problem(
        AnswerFormRules.ANSWER_JSON,
        "This is not valid JSON: the exponent of a number is out of range.",
        file);
  }

  private static AnswerText broken(String file, String text, IOException e) {
    if (isCut(text, e)) {
      return AnswerText.truncated(file, "The answer ends inside its JSON.");
    }
    SourceText source = SourceText.of(file, text);
    JsonLocation place = e instanceof JsonProcessingException json ? json.getLocation() : null;
    return AnswerText.problem(
        Diagnostic.of(
            AnswerFormRules.ANSWER_JSON,
            "This is not valid JSON: " + reason(e),
            place == null ? source.at(0) : source.at(place.getLineNr(), place.getColumnNr())));
  }

  /** Returns whether the only error is an unexpected end. */
  private static boolean isCut(String text, IOException e) {
    if (e instanceof JsonEOFException) {
      return true;
    }
    Matcher word = UNKNOWN_WORD.matcher(reason(e));
    return reason(e).startsWith("Unexpected end-of-input")
        || (word.lookingAt()
            && text.stripTrailing().endsWith(word.group(1))
            && WORDS.stream().anyMatch(known -> known.startsWith(word.group(1))));
  }

  /** Returns the parser's message without the names of its settings. */
  private static String reason(IOException e) {
    if (e instanceof StreamConstraintsException) {
      return "it is nested deeper than " + Document.DEEPEST + " levels, or a token is too long.";
    }
    return e instanceof JsonProcessingException json
        ? json.getOriginalMessage().replaceAll(": enable .*", "")
        : e.getMessage();
  }
}
