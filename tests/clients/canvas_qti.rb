# Reads a package with Instructure's `qti`, by which Canvas's New Quizzes import.
#
#   ruby canvas_qti.rb QTI FOLDER
#
# QTI is a checkout of instructure/qti, FOLDER an unpacked package. Printed is {"version": ..., "groups": [[ident, drawn, points,
# [ident of an item, ...]], ...], "items": {ident: {"type": class, "points": text, "body": html, "scoring": [{...}, ...],
# "answers": [[ident, html], ...], "feedback": {...}, "answer_feedback": [...]}}}.
#
# Two of the gems that it loads only serve what is not used here: classes of its exporter, and MathML outside of texts.

require 'json'
require 'tmpdir'

Dir.mktmpdir do |stubs|
  File.write(File.join(stubs, 'dry-struct.rb'), <<~RUBY)
    require 'dry-types'
    module Dry
      class Struct
        def self.transform_keys(*); end
        def self.transform_types(*); end
        def self.attribute(*); end
        def self.attribute?(*); end
      end
    end
  RUBY
  File.write(File.join(stubs, 'mathml2latex.rb'), <<~RUBY)
    module Mathml2latex
      INSTUCTURE_LATEX_NS = 'latex'.freeze
      class Converter
        def replace_with_latex(*); end
      end
    end
  RUBY
  $LOAD_PATH.unshift(stubs, File.join(ARGV[0], 'lib'))
  require 'active_support'
  require 'qti'
end

def read(item)
  found = item.interaction_model
  scoring = found.scoring_data_structs
  scoring = [] unless scoring.is_a?(Array) # of an essay it is something else
  answers = found.respond_to?(:answers) ? found.answers.map { |each| [each.identifier, each.item_body] } : []
  {
    type: found.class.name.split('::').last, points: item.points_possible, body: item.item_body, title: item.title,
    scoring: scoring.map { |each| each.respond_to?(:to_h) ? each.to_h : { values: each.values } },
    answers: answers, feedback: item.feedback, answer_feedback: item.answer_feedback
  }
end

importer = Qti::Importer.new(ARGV[1])
groups = []
items = {}
importer.assessment_item_refs.each do |ref|
  if (group = importer.create_question_group(ref))
    inside = group.items.map { |node| group.create_assessment_item(node) }
    groups << [group.identifier, group.selection_number, group.points_per_item, inside.map(&:identifier)]
  else
    inside = [importer.create_assessment_item(ref)]
  end
  inside.each { |item| items[item.identifier] = read(item) }
end
puts JSON.generate({ version: Qti::VERSION, title: importer.test_object.title, groups: groups, items: items })
