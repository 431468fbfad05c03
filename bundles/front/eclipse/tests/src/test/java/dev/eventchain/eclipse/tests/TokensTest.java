package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;

import dev.eventchain.eclipse.ui.text.OclTokens;
import dev.eventchain.eclipse.ui.text.Outlines;
import dev.eventchain.eclipse.ui.text.TemplateTokens;
import dev.eventchain.eclipse.ui.text.Token;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the tokens of constraints and templates. */
class TokensTest {

  private static final Path TEXTS = Path.of("src", "test", "resources", "text");
  private static final Path ROOT = Path.of("..", "..", "..", "..").toAbsolutePath().normalize();
  private static final Set<String> TYPES = Set.of("EventChain", "SoftwareNode", "Data");

  @Test
  void constraints() throws IOException {
    String text = Files.readString(TEXTS.resolve("rules.ocl"));
    check("rules.ocl.tokens", table(text, OclTokens.of(text, TYPES)));
    check("rules.ocl.outline", outline(Outlines.constraints(text)));
  }

  @Test
  void templates() throws IOException {
    String text = Files.readString(TEXTS.resolve("node.mtl"));
    check("node.mtl.parts", table(text, TemplateTokens.parts(text)));
    check("node.mtl.tokens", table(text, TemplateTokens.of(text, TYPES)));
    check("node.mtl.outline", outline(Outlines.templates(text)));
  }

  /** The tokens of an incomplete text cover it completely, in order. */
  @Test
  void coverAnyText() throws IOException {
    try (Stream<Path> files = Files.walk(TEXTS)) {
      for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
        String text = Files.readString(file);
        for (int end = 0; end <= text.length(); end++) {
          String part = text.substring(0, end);
          assertEquals(part, joined(part, OclTokens.of(part, TYPES)));
          assertEquals(part, joined(part, TemplateTokens.parts(part)));
          assertEquals(part, joined(part, TemplateTokens.of(part, TYPES)));
        }
      }
    }
  }

  /** The shipped templates contain every kind of tag, and the generator can read them. */
  @Test
  void shippedTemplatesAreOutlined() throws IOException {
    String text = Files.readString(ROOT.resolve("templates/report/html.mtl"));
    List<String> labels = Outlines.templates(text).stream().map(Outlines.Entry::label).toList();
    long declared =
        text.lines().filter(line -> line.startsWith("[query") || line.startsWith("[temp")).count();
    assertEquals(declared, labels.size());
    assertEquals("query html", labels.get(0));
  }

  private static String joined(String text, List<Token> tokens) {
    StringBuilder joined = new StringBuilder();
    for (Token token : tokens) {
      assertEquals(joined.length(), token.start());
      joined.append(token.of(text));
    }
    return joined.toString();
  }

  private static String table(String text, List<Token> tokens) {
    return tokens.stream()
        .map(token -> token.kind() + " " + token.of(text).replace("\n", "⏎") + "\n")
        .collect(Collectors.joining());
  }

  private static String outline(List<Outlines.Entry> entries) {
    return entries.stream()
        .map(entry -> entry.start() + "-" + entry.end() + " " + entry.label() + "\n")
        .collect(Collectors.joining());
  }

  private static void check(String name, String actual) throws IOException {
    Path file = TEXTS.resolve(name);
    if (!Files.exists(file)) {
      Files.writeString(file, actual);
      fail(name + " was missing and is written now: look whether it is right");
    }
    assertEquals(Files.readString(file), actual);
  }
}
