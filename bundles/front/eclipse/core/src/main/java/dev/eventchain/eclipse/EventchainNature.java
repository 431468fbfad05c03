package dev.eventchain.eclipse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.eclipse.core.resources.ICommand;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IProjectDescription;
import org.eclipse.core.resources.IProjectNature;
import org.eclipse.core.runtime.CoreException;

/** Gives a project the builder that checks its models, rules and templates. */
public final class EventchainNature implements IProjectNature {

  private IProject project;

  @Override
  public void configure() throws CoreException {
    IProjectDescription description = project.getDescription();
    List<ICommand> commands = new ArrayList<>(Arrays.asList(description.getBuildSpec()));
    if (commands.stream().anyMatch(EventchainNature::isOurs)) {
      return;
    }
    ICommand ours = description.newCommand();
    ours.setBuilderName(EventchainCore.BUILDER);
    commands.add(ours);
    setBuildSpec(description, commands);
  }

  @Override
  public void deconfigure() throws CoreException {
    IProjectDescription description = project.getDescription();
    List<ICommand> commands = new ArrayList<>(Arrays.asList(description.getBuildSpec()));
    if (commands.removeIf(EventchainNature::isOurs)) {
      setBuildSpec(description, commands);
    }
    ProjectChecks.of(project).forget();
  }

  private void setBuildSpec(IProjectDescription description, List<ICommand> commands)
      throws CoreException {
    description.setBuildSpec(commands.toArray(ICommand[]::new));
    project.setDescription(description, null);
  }

  private static boolean isOurs(ICommand command) {
    return command.getBuilderName().equals(EventchainCore.BUILDER);
  }

  @Override
  public IProject getProject() {
    return project;
  }

  @Override
  public void setProject(IProject project) {
    this.project = project;
  }
}
