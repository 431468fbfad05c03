package dev.eventchain.lsp;

import dev.eventchain.fixtures.EditorClient;
import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.InitializeParams;

/** A session between a server and an editor in the process of the test. */
final class TestSession implements AutoCloseable {

  private static final int BUFFER = 1 << 16;

  final EditorClient client;
  private final CompletableFuture<Integer> exitCode = new CompletableFuture<>();

  TestSession(Path... folders) {
    this(new InitializeParams(), folders);
  }

  TestSession(InitializeParams params, Path... folders) {
    try {
      PipedOutputStream toServer = new PipedOutputStream();
      PipedInputStream serverIn = new PipedInputStream(toServer, BUFFER);
      PipedInputStream fromServer = new PipedInputStream(BUFFER);
      PipedOutputStream serverOut = new PipedOutputStream(fromServer);
      PrintWriter log = new PrintWriter(new StringWriter());
      Thread server =
          new Thread(
              () ->
                  exitCode.complete(LanguageServerProgram.serve(serverIn, serverOut, log, "1.2.3")),
              "server");
      server.setDaemon(true);
      server.start();
      client = new EditorClient(fromServer, toServer, params, folders);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Waits for the end of the server and returns its exit code. */
  int exitCode() {
    return EditorClient.get(exitCode);
  }

  @Override
  public void close() {
    if (!exitCode.isDone()) {
      client.exit();
      exitCode();
    }
  }
}
