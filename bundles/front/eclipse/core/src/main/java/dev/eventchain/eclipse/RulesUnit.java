package dev.eventchain.eclipse;

import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Validation;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * A Complete OCL document; checks that it can be parsed and analysed with the project's metamodels.
 */
record RulesUnit(IFile file, Path path, List<Path> metamodels) implements CheckUnit {

  private static final Set<String> RELEVANT = Set.of("ocl", "ecore");

  @Override
  public IResource subject() {
    return file;
  }

  /** Documents import others and use metamodels. */
  @Override
  public boolean dependsOn(IFile changed) {
    return RELEVANT.contains(CheckedFiles.kind(changed));
  }

  @Override
  public Validation check() {
    return FileChecks.rules(path, metamodels);
  }
}
