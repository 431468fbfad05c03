package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.fixtures.Thorough;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Random edits, always the same ones: when all are undone, the same is found as before. */
class RandomEditsTest {

  private static final int EDITS = Thorough.IS_ON ? 10_000 : 200;

  /** After so many edits, somebody waits for what is found. */
  private static final int PAUSE = 100;

  private static final long MOST_GROWTH = 64L << 20;

  /** How often memory is looked at before it counts as held for ever. */
  private static final int ATTEMPTS = 300;

  private static final List<String> PIECES =
      List.of("", "[", "]", "/]", "[if (", "'", "\n", "\r\n", "self.", "->", "(", ")", "x", "🚀");

  @TempDir private Path folder;

  /** An edit, to be undone: the range of the new text, and the old one. */
  private record Undo(int start, int end, String text) {}

  @Test
  void whatIsUndoneIsFoundAsBefore() throws Exception {
    String rules =
        Files.readString(Repository.ROOT.resolve("metamodel/eventchain.ocl"))
            + "package eventchain context EventChain inv Wrong: self.nothing = 1 endpackage\n";
    edit(Files.writeString(folder.resolve("rules.ocl"), rules));
    String template =
        "[module m('http://eventchain.dev/eventchain/1.0')/]\n"
            + "[template public t(c : EventChain)]\n"
            + "[for (s : SoftwareNode | c.software)][s.name/] [s.nothing/]\n[/for]\n".repeat(50)
            + "[/template]\n";
    edit(Files.writeString(folder.resolve("m.mtl"), template));
  }

  private void edit(Path file) throws Exception {
    Random random = new Random(38);
    try (TestSession session = new TestSession(folder)) {
      EditorClient client = session.client;
      List<Diagnostic> before = client.await(file, each -> !each.isEmpty());
      long used = used();
      String original = Files.readString(file);
      client.open(file, original);
      StringBuilder text = new StringBuilder(original);
      Deque<Undo> undone = new ArrayDeque<>();
      for (int i = 0; i < EDITS; i++) {
        int start = whole(text, random.nextInt(text.length() + 1));
        int end = whole(text, Math.min(text.length(), start + random.nextInt(4)));
        String piece = PIECES.get(random.nextInt(PIECES.size()));
        undone.push(new Undo(start, start + piece.length(), text.substring(start, end)));
        replace(client, file, text, start, end, piece);
        if (i % PAUSE == PAUSE / 2) {
          ask(client, file, new TextLines(text.toString()), start);
        }
      }
      while (!undone.isEmpty()) {
        Undo undo = undone.pop();
        replace(client, file, text, undo.start(), undo.end(), undo.text());
      }
      assertEquals(original, text.toString());
      client.await(file, before::equals);
      assertEquals(0, lastingGrowth(used), "bytes more");
    }
  }

  private static void replace(
      EditorClient client, Path file, StringBuilder text, int start, int end, String piece) {
    TextRange range = new TextLines(text.toString()).range(start, end);
    text.replace(start, end, piece);
    client.change(file, new Range(of(range.start()), of(range.end())), piece);
  }

  /** Returns an offset that is not inside a character or a line break, where no cursor can be. */
  private static int whole(CharSequence text, int offset) {
    boolean inside =
        offset > 0
            && offset < text.length()
            && (Character.isLowSurrogate(text.charAt(offset))
                || (text.charAt(offset) == '\n' && text.charAt(offset - 1) == '\r'));
    return inside ? offset + 1 : offset;
  }

  private static Position of(dev.eventchain.editing.TextPosition position) {
    return new Position(position.line(), position.column());
  }

  /** Half-typed text is answered about, too. */
  private static void ask(EditorClient client, Path file, TextLines lines, int offset)
      throws InterruptedException {
    TextDocumentIdentifier document = new TextDocumentIdentifier(EditorClient.uri(file));
    CompletionParams params = new CompletionParams(document, of(lines.position(offset)));
    assertNotNull(EditorClient.get(client.server().getTextDocumentService().completion(params)));
    assertNotNull(
        EditorClient.get(
            client
                .server()
                .getTextDocumentService()
                .documentSymbol(new DocumentSymbolParams(document))));
    int shown = client.publicationsOf(file);
    for (int i = 0; i < 20 && client.publicationsOf(file) == shown; i++) {
      Thread.sleep(50);
    }
  }

  /**
   * Returns how many bytes more than those used before are still held, 0 if not worth a word. What
   * is being looked through at the moment is let go of soon, however busy the machine is; what
   * leaks never is.
   */
  private static long lastingGrowth(long before) throws InterruptedException {
    long grown = used() - before;
    for (int i = 0; i < ATTEMPTS && grown >= MOST_GROWTH; i++) {
      Thread.sleep(100);
      grown = used() - before;
    }
    return grown < MOST_GROWTH ? 0 : grown;
  }

  private static long used() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }
}
