package dev.eventchain.eclipse.ui.fixes;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.eclipse.EventchainFolders;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.core.resources.IFile;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** A change of a model's element that fixes a finding about it. */
enum ElementFix {
  /** The unit of the other side of the topic. */
  UNIT("Use the unit of the other side") {
    @Override
    boolean apply(EObject element, IFile file) {
      if (!(element instanceof Data data)) {
        return false;
      }
      Optional<String> unit =
          others(data)
              .filter(each -> Objects.equals(each.getFieldName(), data.getFieldName()))
              .map(Data::getUnit)
              .filter(each -> each != null && !each.equals(data.getUnit()))
              .findFirst();
      unit.ifPresent(data::setUnit);
      return unit.isPresent();
    }
  },

  /** The quality of service of the other side of the topic. */
  QUALITY_OF_SERVICE("Use the quality of service of the other side") {
    @Override
    boolean apply(EObject element, IFile file) {
      EObject holder = element instanceof QosProfile ? element.eContainer() : element;
      if (!(holder instanceof Data data)) {
        return false;
      }
      Optional<QosProfile> other =
          others(data)
              .map(Data::getQos)
              .filter(each -> each != null && !EcoreUtil.equals(each, data.getQos()))
              .findFirst();
      other.ifPresent(each -> data.setQos(EcoreUtil.copy(each)));
      return other.isPresent();
    }
  },

  /** The requirement text of the project. */
  REQUIREMENT_TEXT("Write the text of requirements.md into the model") {
    @Override
    boolean apply(EObject element, IFile file) {
      if (!(element instanceof Requirement requirement)) {
        return false;
      }
      Optional<Path> written =
          EventchainFolders.around(file)
              .map(folder -> folder.getLocation().toPath().resolve(ProjectLayout.REQUIREMENTS));
      Optional<String> text =
          written.stream()
              .flatMap(path -> Requirements.read(SourceText.read(path)).items().stream())
              .filter(item -> item.id().equals(requirement.getId()))
              .map(WrittenRequirement::text)
              .findFirst();
      text.ifPresent(requirement::setText);
      return text.isPresent();
    }
  };

  private final String label;

  ElementFix(String label) {
    this.label = label;
  }

  String label() {
    return label;
  }

  /**
   * Changes the element.
   *
   * @param file the file of the model
   * @return true if a replacement was found
   */
  abstract boolean apply(EObject element, IFile file);

  /** Returns the data of the same topic in other components, in the order of the model. */
  private static Stream<Data> others(Data data) {
    return EcoreUtil.getRootContainer(data) instanceof EventChain chain
        ? chain.getData().stream()
            .filter(each -> each != data)
            .filter(each -> Objects.equals(each.getTopicName(), data.getTopicName()))
        : Stream.empty();
  }
}
