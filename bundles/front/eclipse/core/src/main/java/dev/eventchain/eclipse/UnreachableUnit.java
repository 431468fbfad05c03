package dev.eventchain.eclipse;

import dev.eventchain.check.EditorRules;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;

/** A resource that cannot be checked because it is not on a local disk. */
record UnreachableUnit(IResource subject) implements CheckUnit {

  @Override
  public boolean dependsOn(IFile file) {
    return file.equals(subject);
  }

  @Override
  public Validation check() {
    Diagnostic unchecked =
        Diagnostic.of(
                EditorRules.UNCHECKED,
                "This was not checked: it is not on a disk of this machine.",
                SourceLocation.NONE)
            .withHint("Put the project into a folder on this machine.");
    return new Validation(Coverage.NONE, List.of(unchecked));
  }
}
