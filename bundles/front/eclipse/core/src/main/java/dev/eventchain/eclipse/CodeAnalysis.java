package dev.eventchain.eclipse;

import dev.eventchain.constraints.editing.RuleLanguageService;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.LanguageService;
import dev.eventchain.m2t.editing.TemplateLanguageService;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Function;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.QualifiedName;

/**
 * Analysis of the rules and templates of a project, as its editors show them. It answers one
 * question after the other, on a thread of its own.
 */
public final class CodeAnalysis {

  private static final QualifiedName KEY = new QualifiedName(EventchainCore.ID, "analysis");

  private static final long STACK = 16L << 20;

  private static final ExecutorService THREAD =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread answers = new Thread(null, work, "Eventchain: analysis of texts", STACK);
            answers.setDaemon(true);
            return answers;
          });

  private final CodeWorkspace workspace;
  private final List<LanguageService> services;

  private CodeAnalysis(Optional<IProject> project) {
    workspace = new CodeWorkspace(project);
    services = List.of(new RuleLanguageService(workspace), new TemplateLanguageService(workspace));
  }

  /** Returns the analysis of a file's project; of the file alone if it is in none. */
  public static CodeAnalysis of(Optional<IFile> file) {
    if (file.isEmpty()) {
      return new CodeAnalysis(Optional.empty());
    }
    IProject project = file.get().getProject();
    synchronized (KEY) {
      try {
        if (project.getSessionProperty(KEY) instanceof CodeAnalysis known) {
          return known;
        }
        CodeAnalysis created = new CodeAnalysis(Optional.of(project));
        project.setSessionProperty(KEY, created);
        return created;
      } catch (CoreException e) {
        return new CodeAnalysis(Optional.empty()); // closed meanwhile
      }
    }
  }

  /** Takes the text of an editor instead of the one on the disk. */
  public void open(Path file, String text) {
    workspace.open(file, text);
  }

  /** Goes back to the text on the disk. */
  public void close(Path file) {
    workspace.close(file);
  }

  /** Returns the present text of a file; empty if it cannot be read. */
  public Optional<String> text(Path file) {
    return workspace.text(file).map(SourceText::text);
  }

  /** Answers a question about the present text of a file; empty if it is of no known language. */
  public <T> CompletableFuture<Optional<T>> ask(Path file, Function<Analysis, T> question) {
    return CompletableFuture.supplyAsync(
        () ->
            services.stream()
                .filter(each -> each.handles(file))
                .findFirst()
                .flatMap(each -> each.analysis(file))
                .map(question),
        THREAD);
  }
}
