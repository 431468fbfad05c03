package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that template errors are findings with a location, and nothing is written; a killed run
 * leaves complete files.
 */
class BadTemplateTest {

  private static final String HEAD =
      """
      [module main('http://example.org/library')]
      [template public main(library : Library)]
      [comment @main /]
      """;

  private static final int MANY = 1_000;

  @TempDir Path folder;
  private Path ecore;
  private Path model;
  private Path out;
  private Program.Ended ended;

  @BeforeEach
  void write() throws IOException {
    ecore = Files.writeString(folder.resolve("library.ecore"), AnyMetamodelTest.ECORE);
    model = Files.writeString(folder.resolve("model.xmi"), AnyMetamodelTest.MODEL);
    out = folder.resolve("out");
  }

  @AfterEach
  void nobodySeesAStackTrace() {
    if (ended != null) {
      assertFalse((ended.out() + ended.err()).contains("\tat "), ended.out() + ended.err());
      assertFalse((ended.out() + ended.err()).contains("eventchain.defect"), ended.err());
    }
  }

  private Program.Ended generate(byte[] template, Object... more) throws IOException {
    Path file = Files.write(folder.resolve("main.mtl"), template);
    Object[] command = {"generate", "--metamodel", ecore, "--template", file, model, "-o", out};
    ended = new Program().run(Stream.concat(Stream.of(command), Stream.of(more)).toArray());
    return ended;
  }

  private Program.Ended generate(String body) throws IOException {
    return generate((HEAD + body + "\n[/template]\n").getBytes(StandardCharsets.UTF_8));
  }

  @ParameterizedTest(name = "{0} -> {1} {2}")
  @CsvSource(
      delimiter = ';',
      value = {
        "[for (b : Book|library.books)]x;2;m2t.syntax;main.mtl:4:1",
        "[library.boks->size()/];2;ocl.type;main.mtl:4:10",
        "[library.main()/];1;m2t.recursion;main.mtl:2:",
        "[file ('x', false)][library.invoke('java.lang.System', 'exit(int)', Sequence{1})/][/file];2;m2t.service;main.mtl:4:",
        "[file ('a/../../x', false)]x[/file];1;output.path.refused;contains '..'",
        "[file ('a\\u0000b', false)]x[/file];1;output.path.refused;contains a control character",
        "[file ('LONG', false)]x[/file];1;output.path.refused;longer than",
        "[file ('x', false)]1[/file][file ('x', false)]2[/file];1;m2t.file.duplicate;main.mtl:4:",
        "[file ('x', false)][protected ('p')][/protected][protected ('p')][/protected][/file];1;m2t.protected.id;main.mtl:4:",
      })
  void isAFindingWithItsPlace(String body, int code, String id, String place) throws IOException {
    String text = body.replace("LONG", "x".repeat(4096));
    generate(text).expect(code).says("[" + id + "]").says(place);
    assertFalse(Files.exists(out.resolve("x")), "half an output");
  }

  @Test
  void anUndefinedValueCostsNoFileButIsAnError() throws IOException {
    String body = "[file ('x', false)]<[100 / library.books->size().mod(2)/]>[/file]";
    generate(body).expect(1).says("[m2t.undefined]").says("main.mtl:4:");
    assertEquals("<invalid>", Files.readString(out.resolve("x")));
    byte[] template = (HEAD + body + "\n[/template]\n").getBytes(StandardCharsets.UTF_8);
    generate(template, "--lenient").expect(0).says("[m2t.undefined]").says("warning");
  }

  @Test
  void namesThatBeginWithASlashStandBelowTheFolder() throws IOException {
    generate("[file ('/tmp/x', false)]x[/file]").expect(0);
    assertEquals("x", Files.readString(out.resolve("tmp/x")));
  }

  @Test
  void anUnknownCharsetIsAWarningAndTheFileIsUtf8() throws IOException {
    generate("[file ('x', false, 'UTF-99')]ä[/file]").expect(0).says("[m2t.charset]");
    assertEquals("ä", Files.readString(out.resolve("x")));
  }

  @Test
  void whatIsPrintedIsNoFile() throws IOException {
    generate("[file ('stdout', false)]hello[/file]").expect(0);
    assertTrue(ended.err().contains("hello"), ended.err());
    assertFalse(Files.exists(out.resolve("stdout")));
  }

  @Test
  void aDashPrintsToStandardOutputAndFindingsElsewhere() throws IOException {
    String printed = "[file ('stdout', false)]hello[/file]";
    String dash = HEAD + printed + "[file ('x', false)]lost[/file]\n[/template]\n";
    Path file = Files.writeString(folder.resolve("main.mtl"), dash);
    Object[] command = {"generate", "--metamodel", ecore, "--template", file, model, "-o", "-"};
    ended = new Program().run(command).expect(1);
    assertEquals("hello", ended.out());
    String place = "main.mtl:4:" + (printed.length() + "[file (".length() + 1);
    assertTrue(ended.err().contains(place + ": error: The file 'x' is not written"), ended.err());
    Files.writeString(file, dash.replace("'x'", "'stdout'"));
    ended = new Program().run(command).expect(0);
    assertEquals("hellolost", ended.out());
    assertEquals("", ended.err());
    assertFalse(Files.exists(Path.of("-")), "a folder");
  }

  @Test
  void tenThousandNestedBlocksAreRefused() throws IOException {
    generate("[if (true)]".repeat(10_000) + "x" + "[/if]".repeat(10_000))
        .expect(2)
        .says("[m2t.nesting]");
  }

  @Test
  void aTemplateInAnotherEncodingIsRefused() throws IOException {
    generate((HEAD + "schön\n[/template]\n").getBytes(StandardCharsets.ISO_8859_1))
        .expect(2)
        .says("[file.encoding]");
  }

  @Test
  void anOutputThatCannotBeWrittenIsRefused() throws IOException {
    Files.writeString(out, "a file");
    generate("[file ('x', false)]x[/file]").expect(2).says("[output.unwritable]");
    assertEquals("a file", Files.readString(out));
  }

  @Test
  void aKilledRunLeavesWholeFilesAndTheNextOneFinishes() throws Exception {
    String body =
        "[for (b : Book | library.books)][file (b.title, false)]TEXT [b.title/][/file][/for]";
    Files.writeString(model, library());
    generate(body.replace("TEXT", "old")).expect(0);
    Path file = folder.resolve("main.mtl");
    Files.writeString(file, HEAD + body.replace("TEXT", "new") + "\n[/template]\n");
    Process process =
        new Program()
            .start(
                folder.resolve("killed.out"),
                folder.resolve("killed.err"),
                "generate",
                "--metamodel",
                ecore,
                "--template",
                file,
                model,
                "-o",
                out);
    while (process.isAlive() && !Files.readString(out.resolve("book0")).startsWith("new")) {
      Thread.sleep(1);
    }
    process.destroyForcibly();
    process.waitFor();
    TreeSet<String> states = new TreeSet<>();
    for (int i = 0; i < MANY; i++) {
      String text = Files.readString(out.resolve("book" + i));
      assertTrue(text.matches("(old|new) book" + i), text);
      states.add(text.substring(0, 3));
    }
    assertTrue(states.contains("new"), "killed before it wrote anything");
    generate(body.replace("TEXT", "new")).expect(0);
    assertFalse(ended.out().contains("edited"), ended.out());
    assertEquals("new book999", Files.readString(out.resolve("book999")));
  }

  private static String library() {
    StringBuilder books = new StringBuilder();
    for (int i = 0; i < MANY; i++) {
      books.append("<books title=\"book").append(i).append("\"/>\n");
    }
    int start = AnyMetamodelTest.MODEL.indexOf("  <books");
    return AnyMetamodelTest.MODEL.substring(0, start) + books + "</library:Library>\n";
  }
}
