package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.lsp.session.EditorServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DidChangeWatchedFilesParams;
import org.eclipse.lsp4j.FileChangeType;
import org.eclipse.lsp4j.FileEvent;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ServerInfo;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.services.LanguageClient;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The beginning and end of sessions, and the findings about texts as they are typed. */
class SessionTest {

  private static final String TEMPLATE =
      """
      [module list('http://eventchain.dev/eventchain/1.0')/]
      [template public list(c : EventChain)]
      [file (c.name, false)]
      [c.name/]
      [/file]
      [/template]
      """;

  @TempDir private Path folder;

  @Test
  void endsAsAskedOrWhenTheClientIsGone() throws IOException {
    try (TestSession session = new TestSession(folder)) {
      ServerInfo info = session.client.initialized().getServerInfo();
      assertEquals("eventchain 1.2.3", info.getName() + " " + info.getVersion());
      session.client.exit();
      assertEquals(LanguageServerProgram.FINE, session.exitCode());
    }
    try (TestSession session = new TestSession(folder)) {
      session.client.leave();
      assertEquals(LanguageServerProgram.LEFT, session.exitCode());
    }
  }

  @Test
  @Timeout(60)
  void endsWhenTheClientCanNoLongerBeHeard() {
    InputStream broken = new PipedInputStream(); // which nobody has connected
    StringWriter log = new StringWriter();
    PrintWriter writer = new PrintWriter(log);
    OutputStream nobody = OutputStream.nullOutputStream();
    assertEquals(
        LanguageServerProgram.LEFT, LanguageServerProgram.serve(broken, nobody, writer, "1.2.3"));
    assertTrue(log.toString().contains("not connected"), log.toString());
  }

  /** Before that, a client may not be sent anything but the answer to its first question. */
  @Test
  void checksBeginWhenTheClientIsReady() throws Exception {
    Files.writeString(folder.resolve("rules.ocl"), "context Nothing inv A: true");
    CountDownLatch told = new CountDownLatch(1);
    LanguageClient client =
        (LanguageClient)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {LanguageClient.class},
                (proxy, method, arguments) -> {
                  told.countDown();
                  return null;
                });
    try (EditorServer server = new EditorServer("1.2.3", code -> {})) {
      server.connect(client);
      InitializeParams params = new InitializeParams();
      params.setWorkspaceFolders(List.of(new WorkspaceFolder(EditorClient.uri(folder), "here")));
      EditorClient.get(server.initialize(params));
      assertFalse(told.await(500, TimeUnit.MILLISECONDS));
      server.initialized(new InitializedParams());
      assertTrue(told.await(60, TimeUnit.SECONDS));
    }
  }

  @Test
  void endsWithTheProcessOfItsEditor() throws IOException, InterruptedException {
    Process editor = new ProcessBuilder("sleep", "600").start();
    InitializeParams params = new InitializeParams();
    params.setProcessId(Math.toIntExact(editor.pid()));
    try (TestSession session = new TestSession(params, folder)) {
      editor.destroyForcibly().waitFor();
      assertEquals(LanguageServerProgram.LEFT, session.exitCode());
    }
  }

  @Test
  void findsWhatIsTypedAndForgetsWhatIsUndone() throws IOException {
    Path file = Files.writeString(folder.resolve("list.mtl"), TEMPLATE);
    try (TestSession session = new TestSession(folder)) {
      EditorClient client = session.client;
      client.open(file);
      Range name = new Range(new Position(3, 3), new Position(3, 7));
      client.change(file, name, "nam");
      List<Diagnostic> found = client.await(file, each -> !each.isEmpty());
      assertEquals(new Position(3, 3), found.get(0).getRange().getStart(), found.toString());
      assertTrue(
          Files.isRegularFile(
              Path.of(java.net.URI.create(found.get(0).getCodeDescription().getHref()))));
      client.change(file, new Range(new Position(3, 3), new Position(3, 6)), "name");
      client.await(file, List::isEmpty);
    }
  }

  /** Columns are UTF-16 units: a character outside the basic plane counts twice. */
  @ParameterizedTest
  @CsvSource({"'', '\n', 3", "'', '\r\n', 3", "'\uFEFF', '\n', 3", "'', '\n', 10"})
  void countsColumnsAsEditorsDo(String mark, String end, int column) throws IOException {
    String before = column == 3 ? "" : "\uD83D\uDE80\t ab ".substring(0, column - 3);
    String text = mark + TEMPLATE.replace("[c.name/]", before + "[c.nam/]").replace("\n", end);
    Path file = Files.writeString(folder.resolve("list.mtl"), text);
    try (TestSession session = new TestSession(folder)) {
      session.client.open(file);
      List<Diagnostic> found = session.client.await(file, each -> !each.isEmpty());
      assertEquals(
          new Range(new Position(3, column), new Position(3, column + 3)), found.get(0).getRange());
    }
  }

  @Test
  void countsAMarkOnTheFirstLineIfTheEditorHasKeptIt() throws IOException {
    Path file = Files.writeString(folder.resolve("rules.ocl"), "context Nothing inv A: true");
    try (TestSession session = new TestSession(folder)) {
      int without =
          session
              .client
              .await(file, each -> !each.isEmpty())
              .get(0)
              .getRange()
              .getStart()
              .getCharacter();
      session.client.open(file, "\uFEFFcontext Nothing inv A: true");
      session.client.await(
          file,
          each ->
              !each.isEmpty() && each.get(0).getRange().getStart().getCharacter() == without + 1);
    }
  }

  /** What is stale disappears: here a change of the metamodel resolves a finding in a template. */
  @Test
  void checksAgainWhatDependsOnAChangedFile() throws IOException {
    Path ecore = folder.resolve("shop.ecore");
    String metamodel =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
            xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
            xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore"
            name="shop" nsURI="http://example.org/shop" nsPrefix="shop">
          <eClassifiers xsi:type="ecore:EClass" name="Shop"/>
        </ecore:EPackage>
        """;
    Files.writeString(ecore, metamodel);
    Path file =
        Files.writeString(
            folder.resolve("list.mtl"),
            TEMPLATE
                .replace("http://eventchain.dev/eventchain/1.0", "http://example.org/shop")
                .replace("EventChain", "Shop"));
    try (TestSession session = new TestSession(folder)) {
      EditorClient client = session.client;
      client.await(file, each -> !each.isEmpty());
      String named =
          metamodel.replace(
              "name=\"Shop\"/>",
              """
              name="Shop"><eStructuralFeatures xsi:type="ecore:EAttribute" name="name"
                eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/></eClassifiers>
              """);
      client.open(ecore, named);
      client.await(file, List::isEmpty);
      client.close(ecore);
      client.await(file, each -> !each.isEmpty());
      Files.writeString(ecore, named);
      client.server().getWorkspaceService().didChangeWatchedFiles(changed(ecore));
      client.await(file, List::isEmpty);
    }
  }

  private static DidChangeWatchedFilesParams changed(Path file) {
    return new DidChangeWatchedFilesParams(
        List.of(new FileEvent(EditorClient.uri(file), FileChangeType.Changed)));
  }
}
