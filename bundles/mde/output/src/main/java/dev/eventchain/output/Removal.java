package dev.eventchain.output;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Removal of files that earlier runs wrote; {@link OutputFolder} documents the contracts. */
final class Removal {

  private final OutputStorage storage;
  private final FileRecords records;
  private final OutputFindings findings;

  Removal(OutputStorage storage, FileRecords records, OutputFindings findings) {
    this.storage = storage;
    this.records = records;
    this.findings = findings;
  }

  /** As {@link OutputFolder#removeOthers}. */
  List<Diagnostic> others(String folder, Collection<String> produced) {
    Set<String> others = writtenBelow(folder);
    others.removeAll(paths(produced));
    return removeUnlessKept(others);
  }

  /** As {@link OutputFolder#removeFormer}. */
  List<Diagnostic> former(String producer, Collection<String> produced) {
    ProducedFiles files = new ProducedFiles(storage, producer);
    Set<String> current = paths(produced);
    Set<String> former = new TreeSet<>(files.former());
    former.removeAll(current);
    former.retainAll(records.files());
    List<Diagnostic> left = removeUnlessKept(former);
    former.retainAll(records.files());
    current.addAll(former);
    files.remember(current);
    return left;
  }

  /** As {@link OutputFolder#removeAll}. */
  void all(String folder) {
    writtenBelow(folder).forEach(this::delete);
  }

  private Set<String> writtenBelow(String folder) {
    String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
    Set<String> files = records.files();
    files.removeIf(path -> !path.equals(folder) && !path.startsWith(prefix));
    return files;
  }

  private static Set<String> paths(Collection<String> names) {
    return names.stream()
        .map(name -> OutputPath.of(name).value())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private List<Diagnostic> removeUnlessKept(Set<String> paths) {
    return paths.stream().map(this::removeUnlessKept).flatMap(Optional::stream).toList();
  }

  private Optional<Diagnostic> removeUnlessKept(String path) {
    Optional<byte[]> content;
    try {
      content = storage.read(path);
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path), e);
    }
    boolean keeps =
        content.isPresent()
            && (!records.isOurs(path, content.get()) || ProtectedAreas.anyIn(content.get()));
    if (keeps) {
      return Optional.of(findings.abandoned(path));
    }
    delete(path);
    return Optional.empty();
  }

  private void delete(String path) {
    try {
      storage.delete(path);
      records.remove(path);
    } catch (IOException e) {
      throw OutputFindings.unwritable(storage.shown(path), e);
    }
  }
}
