package dev.eventchain.lsp;

import dev.eventchain.lsp.session.EditorServer;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.launch.LSPLauncher;
import org.eclipse.lsp4j.services.LanguageClient;

/** A session of the Language Server Protocol over streams. */
public final class LanguageServerProgram {

  /** The exit code if the client has asked for the end, as the protocol says. */
  public static final int FINE = 0;

  /** The exit code if the client is gone without having asked. */
  public static final int LEFT = 1;

  /** Kept, since the settings of a logger are lost with it. */
  private static final Logger PROTOCOL = Logger.getLogger("org.eclipse.lsp4j");

  static {
    PROTOCOL.setLevel(Level.SEVERE); // the end of a stream is no news
  }

  private LanguageServerProgram() {}

  /**
   * Serves a client until it says so, closes the input, or is gone.
   *
   * @param in what the client says
   * @param out what the client reads, and nothing else
   * @param log what people may read about the session
   * @param version that of the program
   * @return the exit code of the process
   */
  public static int serve(InputStream in, OutputStream out, PrintWriter log, String version) {
    CompletableFuture<Integer> end = new CompletableFuture<>();
    ExecutorService threads = Executors.newCachedThreadPool(LanguageServerProgram::daemon);
    try (EditorServer server = new EditorServer(version, end::complete)) {
      Launcher<LanguageClient> launcher =
          new LSPLauncher.Builder<LanguageClient>()
              .setLocalService(server)
              .setRemoteInterface(LanguageClient.class)
              .setInput(new Watched(in, () -> end.complete(LEFT), log))
              .setOutput(out)
              .setExecutorService(threads)
              .create();
      server.connect(launcher.getRemoteProxy());
      Future<Void> listening = launcher.startListening();
      int code = end.join();
      listening.cancel(true);
      return code;
    } catch (RuntimeException e) {
      log.println("eventchain: the session has failed: " + e);
      return LEFT;
    } finally {
      threads.shutdownNow();
      log.flush();
    }
  }

  private static Thread daemon(Runnable work) {
    Thread thread = new Thread(work, "protocol");
    thread.setDaemon(true);
    return thread;
  }

  /** An input that says when it ends. One that cannot be read has ended: nothing more will come. */
  private static final class Watched extends FilterInputStream {

    private final Runnable end;
    private final PrintWriter log;

    Watched(InputStream in, Runnable end, PrintWriter log) {
      super(in);
      this.end = end;
      this.log = log;
    }

    private interface Reading {
      int read() throws IOException;
    }

    @Override
    public int read() {
      return watched(super::read);
    }

    @Override
    public int read(byte[] bytes, int offset, int length) {
      return watched(() -> super.read(bytes, offset, length));
    }

    private int watched(Reading reading) {
      int result = -1;
      try {
        result = reading.read();
      } catch (IOException e) {
        log.println("eventchain: the client can no longer be heard: " + e);
      }
      if (result < 0) {
        end.run();
      }
      return result;
    }
  }
}
