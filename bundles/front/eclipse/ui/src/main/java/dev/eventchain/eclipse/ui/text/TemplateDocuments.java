package dev.eventchain.eclipse.ui.text;

import org.eclipse.core.filebuffers.IDocumentSetupParticipant;
import org.eclipse.jface.text.IDocument;

/** Partitions documents with templates in any editor. */
public final class TemplateDocuments implements IDocumentSetupParticipant {

  @Override
  public void setup(IDocument document) {
    Partitioner.install(document, Language.TEMPLATE);
  }
}
