package dev.eventchain.lsp.text;

import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.lsp4j.CreateFile;
import org.eclipse.lsp4j.CreateFileOptions;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ResourceOperation;
import org.eclipse.lsp4j.SnippetTextEdit;
import org.eclipse.lsp4j.TextDocumentEdit;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

/** Places and changes in files, under the addresses and in the columns that the editor uses. */
public final class Edits {

  private final OpenTexts texts;
  private boolean versioned;

  /** Creates edits of the texts of a session. */
  public Edits(OpenTexts texts) {
    this.texts = texts;
  }

  /** Says whether the editor takes edits of versions, which it refuses if the text has changed. */
  public void setVersioned(boolean isVersioned) {
    versioned = isVersioned;
  }

  /** Returns the address of a file. */
  public String uri(Path file) {
    return texts.of(file).map(OpenText::uri).orElseGet(() -> file.toUri().toString());
  }

  /** Returns places as locations. */
  public List<Location> locations(List<FileRange> places) {
    return places.stream().map(each -> location(each.file(), each.range())).toList();
  }

  /** Returns a place as a location. */
  public Location location(Path file, TextRange range) {
    return new Location(uri(file), range(file, range));
  }

  /** Returns a range of a file as the editor counts it. */
  public Range range(Path file, TextRange range) {
    return Positions.of(Positions.shifted(range, texts.mark(file)));
  }

  /** Returns a range of a file as the engine counts it. */
  public TextRange range(Path file, Range range) {
    return Positions.shifted(Positions.of(range), -texts.mark(file));
  }

  /** Returns edits of any files as one. */
  public WorkspaceEdit of(List<FileEdit> edits) {
    Map<Path, List<TextEdit>> files = new LinkedHashMap<>();
    for (FileEdit each : edits) {
      files
          .computeIfAbsent(each.file(), key -> new ArrayList<>())
          .add(new TextEdit(range(each.file(), each.range()), each.newText()));
    }
    if (!versioned) {
      Map<String, List<TextEdit>> changes = new LinkedHashMap<>();
      files.forEach((file, changed) -> changes.put(uri(file), changed));
      return new WorkspaceEdit(changes);
    }
    WorkspaceEdit edit = new WorkspaceEdit();
    edit.setDocumentChanges(
        files.entrySet().stream()
            .map(
                each ->
                    Either.<TextDocumentEdit, ResourceOperation>forLeft(
                        new TextDocumentEdit(identifier(each.getKey()), edits(each.getValue()))))
            .toList());
    return edit;
  }

  /**
   * Returns the edit that adds lines at the end of a file.
   *
   * @param text the text of the file; empty if there is none yet
   */
  public WorkspaceEdit appended(Path file, Optional<String> text, String lines) {
    String before = text.orElse("");
    String added = before.isEmpty() || before.endsWith("\n") ? lines : "\n" + lines;
    TextLines all = new TextLines(before);
    WorkspaceEdit edit =
        of(List.of(new FileEdit(file, all.range(before.length(), before.length()), added)));
    if (text.isEmpty() && versioned) {
      List<Either<TextDocumentEdit, ResourceOperation>> changes = new ArrayList<>();
      changes.add(Either.forRight(new CreateFile(uri(file), new CreateFileOptions(false, true))));
      changes.addAll(edit.getDocumentChanges());
      edit.setDocumentChanges(changes);
    }
    return edit;
  }

  private static List<Either<TextEdit, SnippetTextEdit>> edits(List<TextEdit> given) {
    return given.stream().map(Either::<TextEdit, SnippetTextEdit>forLeft).toList();
  }

  private VersionedTextDocumentIdentifier identifier(Path file) {
    Integer version = texts.of(file).map(OpenText::version).orElse(null);
    return new VersionedTextDocumentIdentifier(uri(file), version);
  }
}
