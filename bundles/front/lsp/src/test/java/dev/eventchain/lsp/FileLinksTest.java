package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.fixtures.EditorClient;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.lsp4j.DocumentLink;
import org.eclipse.lsp4j.DocumentLinkParams;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Links of texts to the files that they name. */
class FileLinksTest {

  private static final String ECORE =
      """
      <ecore:EPackage xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shop" nsURI="http://shop/1.0?a&amp;b">
        <eSubpackages name="kinds" nsURI = 'http://shop/kinds'/>
      </ecore:EPackage>
      """;

  @TempDir private Path folder;

  private Path workspace;

  @BeforeEach
  void write() throws IOException {
    workspace = folder.resolve("w");
    for (String file :
        List.of(
            "w/p/eventchain.yaml",
            "w/p/a.vspec",
            "w/p/out.mtl",
            "w/p/campaigns/t.csv",
            "w/rules/shop.ecore",
            "w/rules/base.ocl",
            "w/texts/python/names.mtl",
            "w/texts/base.mtl",
            "w/base.mtl",
            "w/outside-projects.csv",
            "secret.ecore",
            "secret.csv")) {
      Path path = folder.resolve(file);
      Files.createDirectories(path.getParent());
      Files.writeString(path, file.endsWith(".ecore") ? ECORE : "");
    }
    Files.createSymbolicLink(workspace.resolve("p/link.csv"), folder.resolve("secret.csv"));
  }

  private List<DocumentLink> links(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
    try (TestSession session = new TestSession(workspace)) {
      session.client.open(file, text);
      session.client.open(workspace.resolve("rules/wrong.ocl"), "context Nothing inv: true");
      session.client.await(workspace.resolve("rules/wrong.ocl"), each -> !each.isEmpty());
      return EditorClient.get(
          session
              .client
              .server()
              .getTextDocumentService()
              .documentLink(
                  new DocumentLinkParams(new TextDocumentIdentifier(EditorClient.uri(file)))));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "rules/a.ocl         | import 'shop.ecore#/'                          | rules/shop.ecore",
        "rules/a.ocl         | import s : 'shop.ecore'                        | rules/shop.ecore",
        "rules/a.ocl         | import 'base.ocl'                              | rules/base.ocl",
        "rules/a.ocl         | -- import 'base.ocl'                           | ''",
        "rules/a.ocl         | import 'http://example.org/shop'               | ''",
        "rules/a.ocl         | import '../../secret.ecore'                    | ''",
        "texts/a.mtl         | [import python::names /]                       | texts/python/names.mtl",
        "texts/python/a.mtl  | [import python::names /]                       | texts/python/names.mtl",
        "texts/a.mtl         | [module a('http://x') extends base /]          | texts/base.mtl",
        "texts/a.mtl         | [import nothing /]                             | ''",
        "rules/a.ocl         | import s : 'http://shop/1.0?a&b'               | rules/shop.ecore",
        "rules/a.mtl         | [module a('http://shop/1.0?a&b')]              | rules/shop.ecore",
        "rules/a.mtl         | [module a('http://x', 'http://shop/kinds')/]   | rules/shop.ecore",
        "p/a.mtl             | [module a('http://shop/kinds')/]               | rules/shop.ecore",
        "rules/a.mtl         | [a('http://shop/kinds')/]                      | ''",
        "rules/a.xmi         | <s:A xmlns:s=\"http://shop/1.0?a&amp;b\"/>      | rules/shop.ecore",
        "rules/a.xmi         | <s:A xmlns:s='http://other/'/>                 | ''",
        "rules/a.xmi         | <a xsi:schemaLocation=\"http://x shop.ecore#//k\"/> | rules/shop.ecore",
        "rules/a.xmi         | <a xsi:schemaLocation=\"x ../../secret.ecore\"/> | ''",
        "p/eventchain.yaml   | catalogue: {file: a.vspec, overlays: [b.vspec]} | p/a.vspec",
        "p/eventchain.yaml   | template: 'out.mtl' # not a.vspec               | p/out.mtl",
        "p/eventchain.yaml   | template: base.mtl                             | ''",
        "p/eventchain.yaml   | catalogue: ../../secret.csv                    | ''",
        "p/eventchain.yaml   | catalogue: link.csv                            | ''",
        "p/eventchain.yaml   | catalogue: ../outside-projects.csv             | ''",
        "p/campaigns/c.yaml  | x: {csv: t.csv, column: a.b}                   | p/campaigns/t.csv",
      })
  void leadToFilesOfTheWorkspace(String file, String text, String target) throws IOException {
    assertEquals(
        target.isEmpty() ? List.of() : List.of(workspace.resolve(target).toUri().toString()),
        links(workspace.resolve(file), text + "\n").stream().map(DocumentLink::getTarget).toList());
  }

  @Test
  void coverTheName() throws IOException {
    DocumentLink link =
        links(workspace.resolve("texts/a.mtl"), "\n[import python::names /]\n").get(0);
    assertEquals(1, link.getRange().getStart().getLine());
    assertEquals(8, link.getRange().getStart().getCharacter());
    assertEquals(21, link.getRange().getEnd().getCharacter());
  }

  @Test
  void coverEachUri() throws IOException {
    List<DocumentLink> links =
        links(
            workspace.resolve("rules/a.xmi"),
            "<k:A xmlns:k=\"http://shop/kinds\"\n xsi:schemaLocation=\"http://shop/kinds shop.ecore\"/>");
    assertEquals(3, links.size());
    assertEquals(14, links.get(0).getRange().getStart().getCharacter());
    assertEquals(31, links.get(0).getRange().getEnd().getCharacter());
    assertEquals(39, links.get(2).getRange().getStart().getCharacter());
  }

  /** The mark at the start of a text, which the editor has kept, is a column of its first line. */
  @Test
  void countAByteOrderMark() throws IOException {
    DocumentLink link =
        links(workspace.resolve("texts/a.mtl"), "\uFEFF[import python::names /]\n").get(0);
    assertEquals(9, link.getRange().getStart().getCharacter());
    assertEquals(22, link.getRange().getEnd().getCharacter());
  }
}
