/**
 * Files of a run: names, charsets, and protected areas of earlier files. Independent of templates.
 */
package dev.eventchain.m2t.files;
