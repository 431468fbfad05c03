package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.UnsavedTexts;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.m2t.editing.TemplateFormatter;
import dev.eventchain.m2t.syntax.TagBlock;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.ocl.text.Symbol;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Formatted templates, and that they generate what they generated before. */
class TemplateFormatterTest {

  private static final Path SHIPPED = Repository.ROOT.resolve("templates");
  private static final Path CASES = Path.of("src/test/resources/cases");

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(f -> f.toString().endsWith(".mtl")).sorted().toList();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '#',
      quoteCharacter = '"',
      value = {
        "[if(a.b=1and not c)]  x [/if] # [if (a.b = 1 and not c)]  x [/if]",
        "[for(n:Node|t.nodes)separator( ', ' )]a[ /for ] "
            + "# [for (n : Node | t.nodes) separator(', ')]a[/for]",
        "[let a:Integer=-1]  [a  ->max( 2 ) /]  [else]x[/let] "
            + "# [let a : Integer = -1]  [a->max(2) /]  [else]x[/let]",
        "[ 'a [b] ' .concat('  c')/] # ['a [b] '.concat('  c')/]",
        "[module  m( 'http://a','http://b' )  extends x :: y /] "
            + "# [module m('http://a', 'http://b') extends x::y /]",
        "[comment  any   text /][** and  this /] # [comment  any   text /][** and  this /]",
        "[template public t(a:A)?(a.b>1)post(trim()){x:A=a;}]  a  [/template] "
            + "# [template public t(a : A)?(a.b > 1) post(trim()){x : A = a; }]  a  [/template]"
      })
  void tagsHaveTheUsualSpaces(String text, String expected) {
    assertEquals(
        Optional.of(inTemplate(expected.strip())),
        TemplateFormatter.format(inTemplate(text.strip())));
  }

  /** Returns a template with a text, unless that is a declaration. */
  private static String inTemplate(String text) {
    return text.matches("\\[(module|template).*")
        ? text
        : "[template public x(a : A)]" + text + "[/template]";
  }

  @Test
  void onlyTextThatIsNotCopiedLosesSpaces() {
    String text =
        "[module m('x')/]  \n\n[import  a/] \t\r\n[template t(a : A)]  \n x  \n[/template]  \n";
    String expected =
        "[module m('x')/]\n\n[import a/]\r\n[template t(a : A)]  \n x  \n[/template]\n";
    assertEquals(Optional.of(expected), TemplateFormatter.format(text));
  }

  @Test
  void linesInsideATagStay() {
    String text = inTemplate("[a.b  \n      ->select( x|x )   \r\n  -- why  \n  /]");
    String expected = inTemplate("[a.b\n      ->select(x | x)\r\n  -- why\n  /]");
    assertEquals(Optional.of(expected), TemplateFormatter.format(text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "[if (a  =  b)] x",
        "[for (a  |  b)][/if]",
        "[a.b(  'c/]",
        "[comment  a",
        "[a  +  b]"
      })
  void unfinishedTagsLeaveATemplateAlone(String text) {
    assertEquals(Optional.empty(), TemplateFormatter.format(inTemplate(text)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "[a  +  /]",
        "[if (a  ==  b)]x[/if]",
        "[if ((a  = b)]x[/if]",
        "[for (a(  |  b)]x[/for]"
      })
  void unfinishedExpressionsAreLeftAlone(String text) {
    String template = inTemplate(text);
    assertEquals(Optional.of(template), TemplateFormatter.format(template));
  }

  @Test
  void theTemplatesHereAreFormattedOnceAndForAll() throws IOException {
    int formatted = 0;
    List<Path> all = new ArrayList<>(files(SHIPPED));
    all.addAll(files(CASES));
    Random random = new Random(38);
    for (Path file : all) {
      String text = Files.readString(file);
      Optional<String> found = TemplateFormatter.format(text);
      if (found.isPresent()) {
        formatted++;
        assertEquals(found, TemplateFormatter.format(found.get()));
        if (file.startsWith(SHIPPED)) {
          assertEquals(found, TemplateFormatter.format(withOtherSpaces(found.get(), random)));
        }
      }
    }
    assertTrue(formatted > 600, formatted + " templates");
  }

  /**
   * The cases and the shipped templates, all with other spaces in their tags and then formatted.
   */
  @Test
  void formattedTemplatesGenerateTheSame() throws IOException {
    Map<Path, String> texts = new HashMap<>();
    List<Path> all = new ArrayList<>(files(SHIPPED));
    all.addAll(files(CASES));
    Random random = new Random(39);
    int changed = 0;
    for (Path file : all) {
      String text = SourceText.read(file).text();
      String other = withOtherSpaces(text, random);
      changed += other.equals(text) ? 0 : 1;
      TemplateFormatter.format(other)
          .ifPresent(each -> texts.put(file.toAbsolutePath().normalize(), each));
    }
    assertTrue(changed > 400, changed + " templates");
    try (Stream<Path> folders = Files.walk(CASES)) {
      for (Path folder : folders.filter(TemplateFormatterTest::isProductive).sorted().toList()) {
        assertEquals(
            texts(filesIn(folder.resolve("expected"))),
            texts(UnsavedTexts.during(texts, () -> run(folder)).files()),
            folder.toString());
      }
    }
    Path one = files(CASES.resolve("blocks")).get(0);
    assertNotEquals(withOtherSpaces(Files.readString(one), random), Files.readString(one));
  }

  private static boolean isProductive(Path folder) {
    return TemplateCase.isCase(folder)
        && Files.exists(folder.resolve("expected"))
        && Files.notExists(folder.resolve("findings.txt"));
  }

  private static TemplateCase.Outcome run(Path folder) {
    try {
      return new TemplateCase(folder).run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Map<String, byte[]> filesIn(Path folder) throws IOException {
    Map<String, byte[]> files = new TreeMap<>();
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        files.put(folder.relativize(file).toString().replace('\\', '/'), Files.readAllBytes(file));
      }
    }
    return files;
  }

  private static Map<String, String> texts(Map<String, byte[]> files) {
    Map<String, String> texts = new TreeMap<>();
    files.forEach((name, bytes) -> texts.put(name, new String(bytes, UTF_8)));
    return texts;
  }

  /** Returns a template with any spaces in its tags where there are some. */
  private static String withOtherSpaces(String text, Random random) {
    StringBuilder changed = new StringBuilder();
    for (Token token : TagBlock.tokens(SourceText.of("", text))) {
      boolean isTag =
          token.kind() != Token.Kind.TEXT
              && token.kind() != Token.Kind.COMMENT
              && token.kind() != Token.Kind.BROKEN;
      if (!isTag) {
        changed.append(text, token.start(), token.end());
        continue;
      }
      changed.append(text, token.start(), token.contentStart());
      for (Symbol each : Symbol.in(text.substring(token.contentStart(), token.contentEnd()))) {
        boolean stays = each.kind() == Symbol.Kind.COMMENT || each.gap().contains("\n");
        String spaces = " \t  ".substring(random.nextInt(2), 2 + random.nextInt(3));
        changed.append(stays ? each.gap() : each.gap().replace(" ", spaces)).append(each.text());
      }
      changed.append(text, token.contentEnd(), token.end());
    }
    return changed.toString();
  }
}
