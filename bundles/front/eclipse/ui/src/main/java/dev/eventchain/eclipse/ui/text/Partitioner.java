package dev.eventchain.eclipse.ui.text;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.jface.text.DocumentEvent;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IDocumentExtension3;
import org.eclipse.jface.text.IDocumentPartitioner;
import org.eclipse.jface.text.IDocumentPartitionerExtension;
import org.eclipse.jface.text.IRegion;
import org.eclipse.jface.text.ITypedRegion;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.TypedRegion;

/**
 * Partitions the whole document again after each change: a bracket begins a template tag only if
 * its end follows, possibly far away, and these files are short.
 */
final class Partitioner implements IDocumentPartitioner, IDocumentPartitionerExtension {

  private final Language language;
  private IDocument document;
  private List<ITypedRegion> regions = List.of();

  Partitioner(Language language) {
    this.language = language;
  }

  /** Partitions a document, unless it is already partitioned. */
  static void install(IDocument document, Language language) {
    if (document instanceof IDocumentExtension3 several
        && several.getDocumentPartitioner(Language.PARTITIONING) == null) {
      Partitioner partitioner = new Partitioner(language);
      several.setDocumentPartitioner(Language.PARTITIONING, partitioner);
      partitioner.connect(document);
    }
  }

  @Override
  public void connect(IDocument connected) {
    document = connected;
    regions = read();
  }

  @Override
  public void disconnect() {
    document = null;
    regions = List.of();
  }

  private List<ITypedRegion> read() {
    List<ITypedRegion> read = new ArrayList<>();
    int position = 0;
    for (Token part : language.parts(document.get())) {
      addPlain(read, position, part.start());
      String type = part.kind() == TokenKind.COMMENT ? Language.COMMENT : Language.TAG;
      read.add(new TypedRegion(part.start(), part.end() - part.start(), type));
      position = part.end();
    }
    addPlain(read, position, document.getLength());
    if (read.isEmpty()) {
      read.add(new TypedRegion(0, 0, IDocument.DEFAULT_CONTENT_TYPE));
    }
    return read;
  }

  private static void addPlain(List<ITypedRegion> regions, int start, int end) {
    if (end > start) {
      regions.add(new TypedRegion(start, end - start, IDocument.DEFAULT_CONTENT_TYPE));
    }
  }

  @Override
  public void documentAboutToBeChanged(DocumentEvent event) {
    // The old partitions are kept until then.
  }

  @Override
  public boolean documentChanged(DocumentEvent event) {
    return documentChanged2(event) != null;
  }

  @Override
  public IRegion documentChanged2(DocumentEvent event) {
    List<ITypedRegion> before = regions;
    regions = read();
    int same = 0;
    int fewer = Math.min(before.size(), regions.size());
    while (same < fewer && before.get(same).equals(regions.get(same))) {
      same++;
    }
    int moved = event.getText() == null ? 0 : event.getText().length();
    moved -= event.getLength();
    int sameEnds = 0;
    while (sameEnds < fewer - same
        && isMoved(
            before.get(before.size() - 1 - sameEnds),
            regions.get(regions.size() - 1 - sameEnds),
            moved)) {
      sameEnds++;
    }
    if (same + sameEnds >= regions.size()) {
      return before.size() == regions.size() ? null : new Region(event.getOffset(), 0);
    }
    int start = regions.get(same).getOffset();
    ITypedRegion last = regions.get(regions.size() - 1 - sameEnds);
    return new Region(start, last.getOffset() + last.getLength() - start);
  }

  private static boolean isMoved(ITypedRegion before, ITypedRegion now, int moved) {
    return before.getType().equals(now.getType())
        && before.getLength() == now.getLength()
        && before.getOffset() + moved == now.getOffset();
  }

  @Override
  public String[] getLegalContentTypes() {
    return new String[] {IDocument.DEFAULT_CONTENT_TYPE, Language.COMMENT, Language.TAG};
  }

  @Override
  public String getContentType(int offset) {
    return getPartition(offset).getType();
  }

  @Override
  public ITypedRegion getPartition(int offset) {
    for (ITypedRegion region : regions) {
      if (offset < region.getOffset() + region.getLength()) {
        return region;
      }
    }
    return regions.get(regions.size() - 1);
  }

  @Override
  public ITypedRegion[] computePartitioning(int offset, int length) {
    List<ITypedRegion> found = new ArrayList<>();
    for (ITypedRegion region : regions) {
      int start = Math.max(offset, region.getOffset());
      int end = Math.min(offset + length, region.getOffset() + region.getLength());
      if (end > start || length == 0 && end == start && found.isEmpty()) {
        found.add(new TypedRegion(start, end - start, region.getType()));
      }
    }
    return found.toArray(ITypedRegion[]::new);
  }
}
