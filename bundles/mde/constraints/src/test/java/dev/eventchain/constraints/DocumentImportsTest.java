package dev.eventchain.constraints;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.TestModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.emf.ecore.EPackage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Documents that import other documents. */
class DocumentImportsTest {

  private final EPackage metamodel = new TestModels("library").metamodel();

  @TempDir private Path folder;

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private OclRules rules(Path... given) {
    List<SourceText> documents =
        OclRules.files(List.of(given)).stream().map(SourceText::read).toList();
    return OclRules.parse(documents, List.of(metamodel));
  }

  @Test
  void importedDocumentIsCheckedAndItsDefinitionsAreKnown() throws IOException {
    Path main =
        write(
            "main.ocl",
            """
            import 'parts/definitions.ocl'
            import lib : 'platform:/resource/rules/beside.ocl'
            library ocl : 'http://www.eclipse.org/ocl/2015/Library'
            context Book inv Long: isLong()
            """);
    write(
        "parts/definitions.ocl",
        """
        import '../main.ocl'
        context Book
          def: isLong() : Boolean = pages > 300
          inv Titled: title <> ''
        """);
    write("beside.ocl", "include 'main.ocl'\ncontext Library inv Some: books->notEmpty()");
    OclRules rules = rules(main);
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(List.of("Book::Long", "Book::Titled", "Library::Some"), rules.constraintNames());
    assertEquals(3, rules(main, folder.resolve("beside.ocl"), main).documents().size());
  }

  @Test
  void importOfADocumentThatIsNotThereIsAnError() throws IOException {
    Path main = write("main.ocl", "import 'other.ocl'\ncontext Book inv Long: pages > 300");
    write("parts/other.ocl", "context Book inv Titled: title <> ''");
    List<Diagnostic> found = rules(main, folder.resolve("parts/other.ocl")).diagnostics();
    assertEquals(List.of("ocl.import.unknown"), found.stream().map(Diagnostic::id).toList());
    assertEquals(
        "The import names neither a loaded metamodel nor a rules document: 'other.ocl'.",
        found.get(0).message());
    assertEquals(1, found.get(0).location().line());
  }

  @Test
  void importOfAFolderOrAMetamodelIsNoDocument() throws IOException {
    Files.createDirectories(folder.resolve("folder.ocl"));
    Path main =
        write(
            "main.ocl",
            """
            import 'folder.ocl'
            import 'http://www.eclipse.org/ocl/rules.ocl'
            import 'metamodel.ecore'
            context Book inv: true
            """);
    List<Diagnostic> found = rules(main).diagnostics();
    assertEquals(
        List.of("ocl.import.unknown 1", "ocl.import.unknown 2"),
        found.stream().map(each -> each.id() + " " + each.location().line()).toList());
  }
}
