package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationTrace;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.Outcome;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TemplateModuleTest {

  @TempDir Path temporary;

  /** Returns a model of classes, which are model elements like any others. */
  private static EPackage model(int classes) {
    EPackage model = EcoreFactory.eINSTANCE.createEPackage();
    model.setName("model");
    for (int i = 0; i < classes; i++) {
      EClass each = EcoreFactory.eINSTANCE.createEClass();
      each.setName("C" + i);
      model.getEClassifiers().add(each);
    }
    return model;
  }

  private static SourceText template(String fileBody) {
    return SourceText.of(
        "t.mtl",
        "[module t('http://www.eclipse.org/emf/2002/Ecore')]\n"
            + "[template public main(p : EPackage)]\n[comment @main /]\n[file ('out.txt')]\n"
            + fileBody
            + "\n[/file]\n[/template]\n"
            + "[query public label(c : EClass) : String = c.name.toLowerCase() /]\n");
  }

  private static TemplateModule compile(String fileBody) {
    return TemplateModule.compile(
        template(fileBody), name -> Optional.empty(), List.of(EcorePackage.eINSTANCE));
  }

  private static String text(GenerationResult result) {
    assertEquals(List.of(), result.diagnostics());
    return new String(result.files().get("out.txt"), UTF_8);
  }

  @Test
  void aModuleGeneratesInSeveralThreadsAtOnce() throws InterruptedException, ExecutionException {
    TemplateModule module =
        compile(
            "[for (c : EClass | p.eClassifiers->filter(EClass)->sortedBy(name))]\n"
                + "[c.label()/] [c.eContainer(EPackage).name/] [c.name.strtok('C', 0)/]\n[/for]");
    EPackage model = model(300);
    String expected = text(module.generate(List.of(model), each -> SourceLocation.NONE));
    assertEquals(300, expected.lines().count());
    ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      List<Future<String>> results = new ArrayList<>();
      for (int i = 0; i < 16; i++) {
        results.add(
            threads.submit(
                () -> text(module.generate(List.of(model), each -> SourceLocation.NONE))));
      }
      for (Future<String> result : results) {
        assertEquals(expected, result.get());
      }
    } finally {
      threads.shutdown();
    }
  }

  @Test
  void setsReachTheOutputInTheOrderOfTheModel() {
    TemplateModule module = compile("[p.eClassifiers.name->asSet()->union(Set{'x'})->sep(' ')/]");
    String text = text(module.generate(List.of(model(20)), each -> SourceLocation.NONE));
    StringBuilder expected = new StringBuilder();
    for (int i = 0; i < 20; i++) {
      expected.append("C").append(i).append(' ');
    }
    assertEquals(expected + "x\n", text);
  }

  @Test
  void importedModulesAreFoundBesideTheFileOrBelowIt() throws IOException {
    Files.createDirectories(temporary.resolve("a/b"));
    String header = "('http://www.eclipse.org/emf/2002/Ecore')]\n";
    Files.writeString(
        temporary.resolve("main.mtl"),
        "[module main"
            + header
            + "[import a::b::deep]\n[import x::beside]\n"
            + "[template public main(p : EPackage)]\n[comment @main /]\n"
            + "[file ('out.txt')][p.deep()/] [p.beside()/][/file]\n[/template]\n");
    Files.writeString(
        temporary.resolve("a/b/deep.mtl"),
        "[module deep" + header + "[template public deep(p : EPackage)]deep[/template]\n");
    Files.writeString(
        temporary.resolve("beside.mtl"),
        "[module beside" + header + "[template public beside(p : EPackage)]beside[/template]\n");
    TemplateModule module =
        TemplateModule.compile(temporary.resolve("main.mtl"), List.of(EcorePackage.eINSTANCE));
    assertEquals(
        "deep beside", text(module.generate(List.of(model(0)), each -> SourceLocation.NONE)));
  }

  private void shared(String file) throws IOException {
    Path path = temporary.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, sharedText(file).text());
  }

  /** Returns a module that writes its own location. */
  private static SourceText sharedText(String file) {
    String header = "[module m('http://www.eclipse.org/emf/2002/Ecore')]\n";
    String body = "[template public shown(p : EPackage)]" + file + "[/template]\n";
    return SourceText.of(file, header + body);
  }

  /** Returns the location of the module found for a name in a project; empty if none is found. */
  private Optional<String> taken(String name, Optional<SourceText> shipped) throws IOException {
    Path main = temporary.resolve("o/project/src/gen/main.mtl");
    Files.createDirectories(main.getParent());
    Files.writeString(
        main,
        "[module main('http://www.eclipse.org/emf/2002/Ecore')]\n[import "
            + name
            + "]\n[template public main(p : EPackage)]\n[comment @main /]\n"
            + "[file ('out.txt')][p.shown()/][/file]\n[/template]\n");
    try {
      TemplateModule module =
          TemplateModule.compile(main, each -> shipped, List.of(EcorePackage.eINSTANCE));
      return Optional.of(text(module.generate(List.of(model(0)), each -> SourceLocation.NONE)));
    } catch (DiagnosticException e) {
      assertEquals("m2t.module.missing", e.diagnostics().get(0).id());
      return Optional.empty();
    }
  }

  @Test
  void foldersAroundAProjectHaveNoModulesForIt() throws IOException {
    shared("o/files/x.mtl");
    assertEquals(Optional.empty(), taken("files::x", Optional.empty()), "no project is known");
    shared("o/project/files/x.mtl");
    assertEquals(Optional.empty(), taken("files::x", Optional.empty()), "nor is it now");
    Files.createFile(temporary.resolve("o/project/eventchain.yaml"));
    assertEquals(Optional.of("o/project/files/x.mtl"), taken("files::x", Optional.empty()));
    shared("o/project/src/gen/x.mtl");
    assertEquals(Optional.of("o/project/src/gen/x.mtl"), taken("files::x", Optional.empty()));
    Files.delete(temporary.resolve("o/project/src/gen/x.mtl"));
    Files.delete(temporary.resolve("o/project/files/x.mtl"));
    assertEquals(Optional.empty(), taken("files::x", Optional.empty()), "outside the project");
    shared("o/y.mtl");
    assertEquals(Optional.empty(), taken("o::y", Optional.empty()), "by the name of a folder");
  }

  @Test
  void shippedModulesComeBeforeThoseInFoldersThatNobodyNamed() throws IOException {
    Files.createDirectories(temporary.resolve("o/project/META-INF"));
    shared("o/python/names.mtl");
    shared("o/project/python/names.mtl");
    Optional<SourceText> shipped = Optional.of(sharedText("shipped"));
    assertEquals(Optional.of("shipped"), taken("python::names", shipped));
    shared("o/project/src/python/names.mtl");
    assertEquals(
        Optional.of("o/project/src/python/names.mtl"),
        taken("python::names", shipped),
        "beside the folder of the template");
    shared("o/project/src/gen/names.mtl");
    assertEquals(Optional.of("o/project/src/gen/names.mtl"), taken("python::names", shipped));
  }

  @Test
  void aSourceRootIsImpliedByTheFoldersThatAnImportNames() throws IOException {
    shared("o/project/src/gen/x.mtl");
    shared("o/project/files/x.mtl");
    assertEquals(
        Optional.of("o/project/files/x.mtl"), taken("project::files::x", Optional.empty()));
  }

  @Test
  void filesThatCannotBeReadAreNamed() throws IOException {
    Path missing = temporary.resolve("missing.mtl");
    DiagnosticException e =
        assertThrows(
            DiagnosticException.class,
            () -> TemplateModule.compile(missing, List.of(EcorePackage.eINSTANCE)));
    assertEquals("file.missing", e.diagnostics().get(0).id());
    Path latin = temporary.resolve("latin.mtl");
    Files.write(latin, new byte[] {'[', 'm', (byte) 0xe4});
    e =
        assertThrows(
            DiagnosticException.class,
            () -> TemplateModule.compile(latin, List.of(EcorePackage.eINSTANCE)));
    assertEquals("file.encoding", e.diagnostics().get(0).id());
  }

  @Test
  void aPersonsWorkInProtectedAreasSurvivesGenerationIntoAFolder() {
    TemplateModule module =
        compile("# [protected (p.name)]\n# nothing yet\n# [/protected]\n[p.eClassifiers->size()/]");
    Map<String, byte[]> files = new HashMap<>();
    assertEquals(Outcome.WRITTEN, generateInto(files, module, model(1)));
    String first = new String(files.get("out.txt"), UTF_8);
    String edited = first.replace("# nothing yet", "my_code()");
    files.put("out.txt", edited.getBytes(UTF_8));
    assertEquals(Outcome.UNCHANGED, generateInto(files, module, model(1)));
    assertEquals(Outcome.WRITTEN, generateInto(files, module, model(2)));
    String third = new String(files.get("out.txt"), UTF_8);
    assertTrue(third.contains("my_code()") && third.endsWith("2\n"), third);
  }

  @Test
  void aPersonsWorkBetweenCommentsOfXmlSurvivesAnEditorThatLeavesBlanks() {
    TemplateModule module =
        compile("<!-- [protected (p.name)] -->\n<none/>\n<!-- [/protected] -->\n");
    Map<String, byte[]> files = new HashMap<>();
    assertEquals(Outcome.WRITTEN, generateInto(files, module, model(1)));
    String first = new String(files.get("out.txt"), UTF_8);
    String mine = first.replace("<none/>", "<mine/>");
    files.put("out.txt", mine.replaceFirst("-->\n", "-->  \n").getBytes(UTF_8));
    assertEquals(Outcome.WRITTEN, generateInto(files, module, model(1)));
    assertEquals(mine, new String(files.get("out.txt"), UTF_8));
    assertEquals(Outcome.UNCHANGED, generateInto(files, module, model(1)));
  }

  private static Outcome generateInto(
      Map<String, byte[]> files, TemplateModule module, EPackage model) {
    try (OutputFolder folder = OutputFolder.inMemory(files)) {
      GenerationContext context =
          GenerationContext.of(each -> SourceLocation.NONE).withEarlier(folder::read);
      GenerationResult result = module.generate(List.of(model), context);
      return folder.write("out.txt", result.files().get("out.txt")).outcome();
    }
  }

  private static TemplateModule ofPackages(String body) {
    String text =
        "[module t('http://www.eclipse.org/emf/2002/Ecore')]\n"
            + "[template public main(p : EPackage)]\n[comment @main /]\n[file ('out.txt', true)]\n"
            + body
            + "\n[/file]\n[/template]\n";
    return TemplateModule.compile(
        SourceText.of("t.mtl", text),
        name -> Optional.empty(),
        List.of(EcorePackage.eINSTANCE),
        Optional.of(CaseServices.class.getClassLoader()));
  }

  @Test
  void aServiceMayAddToTheModelThatTheTemplatesWalkThrough() {
    Resource resource = new ResourceImpl();
    resource.getContents().add(model(1));
    resource.getContents().add(model(2));
    String call =
        "[invoke('dev.eventchain.m2t.CaseServices', 'grow(org.eclipse.emf.ecore.EObject)',"
            + " Sequence{p})/]";
    GenerationResult result =
        ofPackages(call).generate(resource.getContents(), each -> SourceLocation.NONE);
    assertEquals(List.of(), result.diagnostics());
    assertEquals("grown\n\ngrown\n", new String(result.files().get("out.txt"), UTF_8));
    assertEquals(4, resource.getContents().size());
  }

  @Test
  void whatPeopleWroteIsSavedBeforeTheFileThatLosesIt() {
    SortedMap<String, byte[]> files = new TreeMap<>();
    List.of("a", "b", "b.lost", "c").forEach(name -> files.put(name, name.getBytes(UTF_8)));
    GenerationResult result =
        new GenerationResult(files, List.of(), List.of(), GenerationTrace.NONE);
    assertEquals(List.of("b.lost", "a", "b", "c"), List.copyOf(result.files().keySet()));
  }

  @Test
  void blocksNamedStdoutArePrintedAndNoFiles() {
    TemplateModule module = compile("a[file ('stdout', false)]one\n[/file]");
    GenerationResult result = module.generate(List.of(model(1)), each -> SourceLocation.NONE);
    assertEquals(Set.of("out.txt"), result.files().keySet());
    assertEquals("one\n", result.printedText());
  }

  @Test
  void anErrorOfTheProgramKeepsItsClass() {
    TemplateModule module = ofPackages("[p.eClassifiers->at(7).name/]");
    List<EPackage> model = List.of(model(1));
    LinkageError thrown =
        assertThrows(
            LinkageError.class,
            () ->
                module.generate(
                    model,
                    each -> {
                      throw new LinkageError("a class is missing");
                    }));
    assertEquals("a class is missing", thrown.getMessage());
  }

  @Test
  void aModuleWithoutAnyMetamodelIsToldSo() {
    SourceText text = SourceText.of("m.mtl", "[module m('http://nowhere')/]\n");
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> TemplateModule.compile(text, name -> Optional.empty(), List.of()));
    assertEquals(
        "None is known: name the .ecore file of the metamodel.",
        refused.diagnostics().get(0).hint());
  }
}
