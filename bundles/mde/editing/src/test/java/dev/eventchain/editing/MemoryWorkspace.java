package dev.eventchain.editing;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;

/**
 * A workspace whose texts are put into it, with the same metamodels for all of them. The texts of a
 * folder are checked together. Other files are read from the disk once, such as those of the
 * metamodels.
 */
public final class MemoryWorkspace implements Workspace {

  private final Map<Path, SourceText> texts = new ConcurrentSkipListMap<>();
  private final Map<Path, SourceText> others = new ConcurrentSkipListMap<>();
  private volatile List<EPackage> metamodels;

  /** A workspace without texts. */
  public MemoryWorkspace(List<EPackage> metamodels) {
    this.metamodels = List.copyOf(metamodels);
  }

  /** Adds or replaces a text. */
  public void put(Path file, String text) {
    texts.put(file, SourceText.of(file.toString(), text));
  }

  /** Removes a text. */
  public void remove(Path file) {
    texts.remove(file);
  }

  /** Replaces the metamodels. */
  public void setMetamodels(List<EPackage> present) {
    metamodels = List.copyOf(present);
  }

  @Override
  public List<Path> files() {
    return new ArrayList<>(texts.keySet());
  }

  @Override
  public Optional<SourceText> text(Path file) {
    SourceText known = texts.get(file);
    if (known != null) {
      return Optional.of(known);
    }
    return Files.isRegularFile(file)
        ? Optional.of(others.computeIfAbsent(file, SourceText::read))
        : Optional.empty();
  }

  @Override
  public List<EPackage> metamodels(Path file) {
    return metamodels;
  }

  @Override
  public Set<Path> checkedTogether(Path file) {
    return Stream.concat(Stream.of(file), texts.keySet().stream())
        .filter(each -> Objects.equals(each.getParent(), file.getParent()))
        .collect(Collectors.toSet());
  }
}
