package dev.eventchain.eclipse;

import dev.eventchain.check.FileChecks;
import dev.eventchain.check.Validation;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/**
 * An Ecore metamodel, which has to be valid before models and rules can use it.
 *
 * @param all the metamodels of the project, which must not contradict each other
 */
record MetamodelUnit(IFile file, Path path, List<Path> all) implements CheckUnit {

  @Override
  public IResource subject() {
    return file;
  }

  /** Metamodels may refer to each other. */
  @Override
  public boolean dependsOn(IFile changed) {
    return CheckedFiles.kind(changed).equals("ecore");
  }

  @Override
  public Validation check() {
    return FileChecks.metamodel(path, all);
  }
}
