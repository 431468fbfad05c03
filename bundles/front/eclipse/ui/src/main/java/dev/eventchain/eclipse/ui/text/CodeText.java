package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.CodeAnalysis;
import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.Platform;
import org.eclipse.jface.text.DocumentEvent;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IDocumentListener;
import org.eclipse.swt.widgets.Display;

/**
 * The text of an editor. It is analysed after each change, in the background; what is found about a
 * text that has changed again is dropped.
 */
final class CodeText implements IDocumentListener {

  /** The present text; the same instance until it changes. */
  record Present(String text, TextLines lines) {}

  /** Parts of a text that are shown. */
  record Known(
      Present present,
      List<SemanticToken> tokens,
      List<CodeColors.Colored> colors,
      List<Symbol> symbols,
      List<Folding> foldings) {}

  private final Language language;
  private final IDocument document;
  private final Path path;
  private final CodeAnalysis analysis;
  private final Consumer<Known> show;
  private final Display display = Display.getCurrent();
  private volatile Present present;
  private volatile boolean closed;

  /**
   * Begins with the present text of a document; on the user interface's thread.
   *
   * @param file empty outside of Eclipse's workspace
   * @param show is called on the user interface's thread
   */
  CodeText(
      Language language,
      IDocument document,
      Optional<IFile> file,
      Path path,
      Consumer<Known> show) {
    this.language = language;
    this.document = document;
    this.path = file.map(IFile::getLocation).map(IPath::toPath).orElse(path);
    this.analysis = CodeAnalysis.of(file);
    this.show = show;
    document.addDocumentListener(this);
    take();
  }

  Path path() {
    return path;
  }

  Present present() {
    return present;
  }

  /** Returns the present texts of files of the project; only in answers, since it reads files. */
  Map<Path, String> textsOf(Collection<Path> files) {
    Map<Path, String> texts = new LinkedHashMap<>();
    files.forEach(file -> texts.computeIfAbsent(file, it -> analysis.text(it).orElse("")));
    return texts;
  }

  /** Goes back to the text on the disk. */
  void close() {
    closed = true;
    document.removeDocumentListener(this);
    analysis.close(path);
  }

  @Override
  public void documentAboutToBeChanged(DocumentEvent event) {
    // Only the result matters.
  }

  @Override
  public void documentChanged(DocumentEvent event) {
    take();
  }

  private void take() {
    String text = document.get();
    present = new Present(text, new TextLines(text));
    refresh();
  }

  /** Analyses the present text again, since other files may have changed. */
  void refresh() {
    Present asked = present;
    analysis.open(path, asked.text());
    analysis
        .ask(path, found -> asked == present && !closed ? known(asked, found) : null)
        .thenAccept(known -> known.ifPresent(each -> later(() -> shown(each))))
        .exceptionally(this::failed);
  }

  private Known known(Present asked, Analysis found) {
    return new Known(
        asked,
        found.tokens(),
        CodeColors.of(language, asked.text(), asked.lines(), found.tokens()),
        found.symbols(),
        found.foldings());
  }

  private void shown(Known known) {
    if (known.present() == present && !closed) {
      show.accept(known);
    }
  }

  private void later(Runnable work) {
    if (!display.isDisposed()) {
      display.asyncExec(work);
    }
  }

  private Void failed(Throwable failure) {
    Platform.getLog(CodeText.class).error("The analysis of " + path + " failed.", failure);
    return null; // the only value
  }

  /** Answers a question about an offset in the present text. */
  <T> CompletableFuture<Optional<T>> ask(
      int offset, BiFunction<Analysis, TextPosition, T> question) {
    TextPosition position = present.lines().position(offset);
    return analysis.ask(path, found -> question.apply(found, position));
  }

  /** As {@link #ask}, with the answer on the user interface's thread. */
  <T> void ask(int offset, BiFunction<Analysis, TextPosition, T> question, Consumer<T> then) {
    ask(offset, question, then, () -> {});
  }

  /**
   * As above.
   *
   * @param otherwise is called if there is no answer, also since the analysis failed
   */
  <T> void ask(
      int offset,
      BiFunction<Analysis, TextPosition, T> question,
      Consumer<T> then,
      Runnable otherwise) {
    ask(offset, question)
        .exceptionally(
            failure -> {
              failed(failure);
              return Optional.empty();
            })
        .thenAccept(
            answer ->
                later(
                    () -> {
                      if (!closed) {
                        answer.ifPresentOrElse(then, otherwise);
                      }
                    }))
        .exceptionally(this::failed);
  }
}
