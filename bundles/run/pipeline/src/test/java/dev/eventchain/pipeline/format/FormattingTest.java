package dev.eventchain.pipeline.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.LocalDate;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that a command formats, or finds not to be formatted. */
class FormattingTest {

  private static final String RULES = "context EventChain\ninv A:self.name<>''\n";
  private static final String FORMATTED = "context EventChain\n  inv A: self.name <> ''\n";

  @TempDir private Path folder;

  private Path file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private static Formatting.Result format(Path... named) {
    return Formatting.of(List.of(named), 2, true);
  }

  private static List<String> found(Formatting.Result result) {
    return result.found().stream().map(FormattingTest::described).toList();
  }

  private static String described(Diagnostic finding) {
    String place = finding.location().toString();
    return place.substring(place.lastIndexOf('/') + 1) + " " + finding.id();
  }

  private List<String> names(List<Path> files) {
    return files.stream().map(each -> folder.relativize(each).toString()).toList();
  }

  @Test
  void eachKindOfFileIsFormatted() throws IOException {
    file("eventchain.yaml", "name:   x  \nrun:\n    a: 1\n");
    file("a/constraints.ocl", RULES);
    file("a/t.mtl", "[module  t( 'http://x' )/]  \n");
    Formatting.Result result = format(folder);
    assertEquals(List.of("a/constraints.ocl", "a/t.mtl", "eventchain.yaml"), names(result.files()));
    assertEquals(result.files(), result.changed());
    assertEquals(List.of(), result.found());
    assertEquals(FORMATTED, Files.readString(folder.resolve("a/constraints.ocl")));
    assertEquals("[module t('http://x')/]\n", Files.readString(folder.resolve("a/t.mtl")));
    assertEquals("name:   x\nrun:\n  a: 1\n", Files.readString(folder.resolve("eventchain.yaml")));
    assertEquals(List.of(), format(folder).changed());
  }

  @Test
  void aCheckWritesNothingAndNamesTheFirstDifference() throws IOException {
    Path rules = file("a.ocl", "-- é\n" + RULES);
    Path good = file("b.ocl", FORMATTED);
    Path end = file("c.yaml", "a: 1\n\n\n");
    Formatting.Result result = Formatting.of(List.of(rules, good, end), 2, false);
    assertEquals(List.of("a.ocl:3:1 format.differs", "c.yaml:2:1 format.differs"), found(result));
    assertEquals("inv A:self.name<>''", result.found().get(0).location().excerpt());
    assertEquals("Run 'eventchain format " + rules + "'.", result.found().get(0).hint());
    assertEquals(List.of(), result.changed());
    assertEquals("-- é\n" + RULES, Files.readString(rules));
    assertEquals(List.of(), Formatting.of(List.of(good), 2, false).found());
    Formatting.Result wider = Formatting.of(List.of(good), 4, false);
    assertEquals(List.of("b.ocl:2:3 format.differs"), found(wider));
    assertEquals("Run 'eventchain format --indent 4 " + good + "'.", wider.found().get(0).hint());
  }

  @Test
  void lineEndsMarksAndPermissionsStay() throws IOException {
    String windows = "\uFEFF" + RULES.replace("\n", "\r\n");
    Path rules = file("a.ocl", windows);
    Files.setPosixFilePermissions(rules, PosixFilePermissions.fromString("rw-r-----"));
    assertEquals(List.of(rules), format(rules).changed());
    assertEquals("\uFEFF" + FORMATTED.replace("\n", "\r\n"), Files.readString(rules));
    assertEquals("rw-r-----", PosixFilePermissions.toString(Files.getPosixFilePermissions(rules)));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(rules), files.toList());
    }
  }

  @Test
  void whatCannotBeReadStays() throws IOException {
    Path rules = file("a.ocl", "context A\ninv  B: (self.\n");
    Path clause = file("b.ocl", "context  A\ninv B: 1 = = 2\n");
    Path template = file("c.mtl", "[module  m('http://x')/]\n[template public t(a : A)]\n");
    Path yaml = file("d.yaml", "a:   \n   - [b\n");
    Path latin = folder.resolve("e.ocl");
    Files.write(latin, new byte[] {'-', '-', (byte) 0xe9, '\n'});
    Path good = file("f.ocl", RULES);
    Formatting.Result result = format(rules, clause, template, yaml, latin, good);
    assertEquals(
        List.of(
            "a.ocl:2:14 format.syntax",
            "b.ocl:2:12 format.syntax",
            "c.mtl:2:1 format.syntax",
            "d.yaml:3:1 format.syntax",
            "e.ocl:1 file.encoding"),
        found(result));
    assertEquals(List.of(good), result.changed());
    assertEquals("a:   \n   - [b\n", Files.readString(yaml));
  }

  /** Readers of YAML refuse an alias of nothing, and so does the program. */
  @Test
  void aliasesOfNothingAreErrors() throws IOException {
    Path good = file("a.yaml", "a: &x 1\nb: *x\nc: &x 2\n");
    Path never = file("b.yaml", "a: 1\nb: *x\n");
    Path later = file("c.yaml", "b: [*x]\na: &x 1\n");
    Path other = file("d.yaml", "a: &x 1\n---\nb:   *x\n");
    Formatting.Result result = Formatting.of(List.of(good, never, later, other), 2, false);
    assertEquals(
        List.of("b.yaml:2:4 format.syntax", "c.yaml:1:5 format.syntax", "d.yaml:3:6 format.syntax"),
        found(result));
  }

  /** A correct text that is not formatted is no error. */
  @Test
  void whatIsReadButNotFormattedIsSaid() throws IOException {
    Path odd = file("a.yaml", "? [a,   b]\n:   1\n");
    Formatting.Result result = format(odd);
    assertEquals(List.of("a.yaml format.skipped"), found(result));
    assertFalse(Diagnostic.anyError(result.found()));
    assertEquals("? [a,   b]\n:   1\n", Files.readString(odd));
  }

  @Test
  void resultsAndFoldersOfToolsAreLeftOut() throws IOException {
    file("p/eventchain.yaml", "name: x\n");
    file("p/scenarios/a.yaml", "a: 1\n");
    for (String name : List.of("p/out/x", "p/recordings/x", "p/.git/x", "p/.x", "target/x")) {
      file(name + ".yaml", "a:   1  \n");
      file(name + ".ocl", RULES);
    }
    file("elsewhere/.eventchain/files.json", "{\"a/written.ocl\": \"0\"}");
    file("elsewhere/a/written.ocl", RULES);
    file("elsewhere/.eventchain/files.journal", "0".repeat(64) + " b/announced.ocl\n");
    file("elsewhere/b/announced.ocl", RULES);
    file("elsewhere/own.ocl", FORMATTED);
    file("elsewhere.yaml", "a:   1  \n");
    file("out/own.ocl", FORMATTED);
    assertEquals(
        List.of("elsewhere/own.ocl", "out/own.ocl", "p/eventchain.yaml", "p/scenarios/a.yaml"),
        names(format(folder).files()));
    for (String name : List.of("p/out", "p/out/x", "p/recordings")) {
      file(name + "/y/z.ocl", RULES);
      assertEquals(
          List.of("format.nothing"),
          format(folder.resolve(name)).found().stream().map(Diagnostic::id).toList());
      assertEquals(RULES, Files.readString(folder.resolve(name + "/y/z.ocl")));
    }
  }

  /** As a hook names them, which passes each file of a commit. */
  @Test
  void resultsThatAreNamedAreLeftOutAndSaid() throws IOException {
    file("p/eventchain.yaml", "name: x\n");
    file("elsewhere/.eventchain/files.json", "{\"a/written.ocl\": \"0\"}");
    Path result = file("p/out/x/a.ocl", RULES);
    Path recording = file("p/recordings/b.yaml", "a:   1  \n");
    Path written = file("elsewhere/a/written.ocl", RULES);
    Path own = file("elsewhere/a/own.ocl", RULES);
    Formatting.Result formatted = format(result, recording, written, own);
    assertEquals(List.of(own), formatted.changed());
    assertEquals(
        List.of("a.ocl format.skipped", "b.yaml format.skipped", "written.ocl format.skipped"),
        found(formatted));
    assertEquals(RULES, Files.readString(written));
    assertEquals(List.of("elsewhere/a/own.ocl"), names(format(own.getParent()).files()));
  }

  @Test
  void theExamplesAreFormatted() {
    Formatting.Result result =
        Formatting.of(List.of(Repository.ROOT.resolve("examples")), 2, false);
    assertEquals(List.of(), found(result));
    assertTrue(result.files().size() > 100, result.files()::toString);
  }

  @Test
  void nothingToFormatIsAnError() throws IOException {
    Path model = file("chain.xmi", "<a/>");
    Path empty = Files.createDirectory(folder.resolve("empty"));
    Formatting.Result result = Formatting.of(List.of(model, empty), 2, false);
    assertEquals(List.of("chain.xmi format.nothing", "empty format.nothing"), found(result));
    assertThrows(DiagnosticException.class, () -> format(folder.resolve("none.ocl")));
  }

  @Test
  void yamlOutsideOfProjectsIsFormattedIfItIsNamed() throws IOException {
    Path file = file("a.yaml", "a:\n    b: 1\n");
    assertEquals(List.of(file), format(file).changed());
  }

  @Test
  void linksOutOfAProjectAreNotFollowed() throws IOException {
    Path outside = file("elsewhere/rules.ocl", RULES);
    file("p/eventchain.yaml", "name: x\n");
    Path inside = file("p/own.ocl", RULES);
    Path link = Files.createSymbolicLink(folder.resolve("p/link.ocl"), outside);
    Path libraries = Files.createSymbolicLink(folder.resolve("p/more"), outside.getParent());
    Path same = Files.createSymbolicLink(folder.resolve("p/same.ocl"), Path.of("own.ocl"));
    Formatting.Result result = format(link, libraries, libraries.resolve("rules.ocl"));
    assertEquals(
        List.of("link.ocl format.outside", "more format.outside", "rules.ocl format.outside"),
        found(result));
    assertEquals(
        List.of("p/eventchain.yaml", "p/own.ocl"), names(format(folder.resolve("p")).files()));
    assertEquals(RULES, Files.readString(outside));
    Files.writeString(inside, RULES);
    assertEquals(List.of(same), format(same, inside).changed());
    assertTrue(Files.isSymbolicLink(same));
    assertEquals(FORMATTED, Files.readString(inside));
    Path project = Files.createSymbolicLink(folder.resolve("link"), folder.resolve("p"));
    assertEquals(List.of(), format(project).found());
  }

  @Test
  void aFileThatCannotBeWrittenIsFound() throws IOException {
    Path file = file("a".repeat(220) + ".ocl", RULES); // its name leaves no room for a new file
    Formatting.Result result = format(file);
    assertEquals(
        List.of("format.unwritable"), result.found().stream().map(Diagnostic::id).toList());
    assertEquals(List.of(), result.changed());
    assertEquals(RULES, Files.readString(file));
  }

  /** Such as an editor and a hook; the result is the same. */
  @Test
  void whatAnotherOneFormatsAtTheSameTimeIsNoError() throws IOException {
    for (int i = 0; i < 300; i++) {
      file("r" + i + ".ocl", RULES);
    }
    List<CompletableFuture<Formatting.Result>> both =
        Stream.generate(() -> CompletableFuture.supplyAsync(() -> format(folder)))
            .limit(2)
            .toList();
    for (CompletableFuture<Formatting.Result> each : both) {
      assertEquals(List.of(), found(each.join()));
    }
    assertEquals(FORMATTED, Files.readString(folder.resolve("r299.ocl")));
  }

  /** As a hook names the files of a commit. */
  @Test
  void eachFileIsUnderTheSuppressionsOfItsOwnProject() throws IOException {
    for (String name : List.of("p", "q")) {
      file(name + "/eventchain.yaml", "name: x\n");
    }
    List<Path> all =
        List.of(
            file("p/a.ocl", RULES),
            file("q/a.ocl", RULES),
            file("a.ocl", RULES),
            file("p/b/c.ocl", RULES));
    Formatting.Result result = Formatting.of(all, 2, false);
    Suppressions accepting = new Suppressions(List.of(entry("a.ocl")), LocalDate.EPOCH);
    Outcome own =
        Formatting.outcome(
            result, of -> of.filter(this::isFirst).map(it -> accepting).orElse(Suppressions.NONE));
    assertEquals(1, own.exitCode());
    assertEquals(4, own.coverage().files().size());
    assertEquals(
        List.of("p/a.ocl"), own.suppressed().stream().map(it -> shown(it.finding())).toList());
    assertEquals(
        List.of("p/b/c.ocl", "q/a.ocl", "a.ocl"),
        own.diagnostics().stream().map(this::shown).toList());
    assertEquals(3, Formatting.outcome(result, of -> accepting).suppressed().size());
    Outcome nothing = Formatting.outcome(Formatting.of(List.of(), 2, false), of -> accepting);
    assertEquals(0, nothing.exitCode());
  }

  /** Findings about suppressions have the place that the files have. */
  @Test
  void projectsAreNamedAsTheirFilesAre() throws IOException {
    file("p/eventchain.yaml", "name: x\n");
    Path all = Path.of("").toAbsolutePath().relativize(file("p/a/b.ocl", RULES));
    Set<Path> projects = new HashSet<>();
    for (Path named : List.of(all, all.toAbsolutePath().normalize())) {
      Formatting.outcome(
          Formatting.of(List.of(named), 2, false),
          of -> {
            projects.add(of.orElseThrow().folder());
            return Suppressions.NONE;
          });
    }
    Path relative = all.getParent().getParent();
    assertEquals(Set.of(relative, relative.toAbsolutePath().normalize()), projects);
  }

  private boolean isFirst(ProjectFolder project) {
    return project.folder().endsWith("p");
  }

  private String shown(Diagnostic finding) {
    return folder.relativize(Path.of(finding.location().file())).toString();
  }

  private static Suppressions.Entry entry(String file) {
    return new Suppressions.Entry(
        "format.differs", "", "", file, "", "as it was", LocalDate.MAX, SourceLocation.NONE);
  }
}
