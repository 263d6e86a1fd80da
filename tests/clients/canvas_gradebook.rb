# What Canvas's gradebook importer makes of a file of marks: its own `lib/gradebook_importer.rb`, upon a course in memory.
#
#   ruby canvas_gradebook.rb IMPORTER COURSE.json FILE
#
# COURSE.json is {"students": [{"id", "name", "sortable_name", "sis", "login"}, ...], "assignments": [{"id", "title", "out_of"}, ...],
# "notes": [title of a column, ...], "scores": [[student, assignment, number or "EX"], ...]}. Printed is {"refused": sentence}, or
# {"asks": {"students": [name, ...], "assignments": [title, ...]}, "scores": [[student, assignment, number or "EX" or null], ...]}:
# of whom and what the page that follows asks, and what stands in the gradebook when it is answered with "ignore". The classes
# below stand where Canvas has its database; of what they know the importer asks everything by itself. What the page posts is
# `populateGradeDataPerSubmission` (ui/features/gradebook_uploads), what becomes of it `Submission.process_bulk_update`.

require 'csv'
require 'json'
require 'set'
require 'active_support'
require 'active_support/core_ext'

FasterCSV = CSV # its name in Canvas of 2013

def I18n.n(number, precision:)
  ActiveSupport::NumberHelper.number_to_rounded(number, precision: precision)
end

# Records that were found, by queries that leave nothing out.
class Found < Array
  def where(given = {})
    kept = given.transform_values { |each| each.map { |one| one.respond_to?(:id) ? one.id : one } }
    Found.new(select { |record| kept.all? { |field, values| values.include?(record.public_send(field)) } })
  end

  def select(*fields, &block)
    block ? Found.new(super(&block)) : self
  end

  def find(*given, &block)
    block ? super(&block) : where(given.last[:conditions] || {})
  end

  def preload(*) = self
  def published = self
  def gradeable = self
  def active = self
  def find_by(*) = nil
  def build = Assignment.new(title: '')
end

class Assignment
  attr_accessor :id, :title, :previous_id, :original_id, :grading_type
  attr_reader :points_possible

  def initialize(title:, id: nil, out_of: nil)
    @id, @title, @known, @before, @points_possible, @grading_type = id, title, !id.nil?, out_of, out_of, 'points'
  end

  def self.title_and_id(text)
    text =~ /\A(.*)\s\((\d+)\)\z/ ? [$1, $2] : [text, nil]
  end

  def self.preload_unposted_anonymous_submissions(*); end

  def points_possible=(number)
    @points_possible = number.to_f
  end

  def changed? = !@known || @points_possible != @before
  def new_record? = !@known
  def has_sub_assignments? = false
  def sub_assignment_tag = nil
  def unposted_anonymous_submissions? = false
end

class User
  attr_accessor :id, :name, :sortable_name, :previous_id, :original_id

  def initialize(name:, id: nil, sortable_name: name)
    @id, @name, @sortable_name, @known, @attributes = id, name, sortable_name, !id.nil?, {}
  end

  def new_record? = !@known
  def last_name_first = @sortable_name
  def read_attribute(key) = @attributes[key]
  def write_attribute(key, value) = @attributes[key] = value
end

class Submission
  attr_accessor :user, :assignment, :score, :excused, :cached_due_date, :grading_period_id

  def initialize(user = nil, assignment = nil, mark = nil)
    @user, @assignment, @score, @excused = user, assignment, mark == 'EX' ? nil : mark&.to_f, mark == 'EX'
  end

  def user_id = @user.id
  def assignment_id = @assignment.id
  def excused? = @excused
  def grants_right?(*) = true
end

Pseudonym = Struct.new(:id, :unique_id, :sis_user_id, :user_id)
NotesColumn = Struct.new(:id, :title, :read_only, :custom_gradebook_column_data) do
  def deleted? = false
end

class Account
  attr_reader :pseudonyms

  def initialize(pseudonyms)
    @pseudonyms = pseudonyms
  end

  def id = 1
  def shard = self
  def activate = yield
  def allow_gradebook_show_first_last_names? = true
  def feature_enabled?(*) = true
  def self.site_admin = new(Found.new)
end

class Course
  attr_accessor :assignments, :students, :submissions
  attr_reader :account, :custom_gradebook_columns

  def initialize(given)
    @students = Found.new(given['students'].map { |each| User.new(**each.slice('id', 'name', 'sortable_name').symbolize_keys) })
    @assignments = Found.new(given['assignments'].map { |each| Assignment.new(**each.symbolize_keys) })
    record = ->(records, id) { records.find { |each| each.id == id } }
    @submissions = Found.new(given['scores'].map do |student, assignment, mark|
      Submission.new(record[@students, student], record[@assignments, assignment], mark)
    end)
    @account = Account.new(Found.new(given['students'].map { |each| Pseudonym.new(0, each['login'], each['sis'], each['id']) }))
    columns = given['notes'].each_with_index.map { |title, at| NotesColumn.new(at + 1, title, false, []) }
    @custom_gradebook_columns = Found.new(columns)
  end

  def all_students = @students
  def gradable_students = Found.new(@students.map { |each| { user_id: each.id } })
  def root_account = @account
  def preload_user_roles!; end
  def custom_grade_statuses = Found.new
  def account_membership_allows(*) = true
  def account_membership_allows?(*) = true
  def assigned_assignment_ids_by_user = @students.to_h { |each| [each.id, @assignments.map(&:id).to_set] }
  def grading_periods? = false
  def allow_final_grade_override? = false
  def discussion_checkpoints_enabled? = false
end

module GuardRail
  def self.activate(*) = yield
end

module GradingPeriod
  def self.for(*) = Found.new
end

module EffectiveDueDates
  def self.for_course(*) = self
  def self.find_effective_due_date(*) = {}
end

Upload = Struct.new(:course, :gradebook) do
  def save!; end
end
Progress = Struct.new(:message, :workflow_state) do
  def save; end
end
Attachment = Struct.new(:path) do
  def open = File.new(path)
end

# What the importer tells the page, or why it takes nothing.
def imported(course, path)
  if GradebookImporter.instance_method(:initialize).parameters.map(&:last).include?(:contents)
    importer = GradebookImporter.new(course, File.read(path, encoding: 'UTF-8'))
    importer.parse!
    return JSON.parse(importer.to_json)
  end
  upload, progress = Upload.new(course), Progress.new
  GradebookImporter.new(upload, Attachment.new(path), User.new(name: 'Teacher'), progress).parse!
  upload.gradebook ? JSON.parse(upload.gradebook.to_json) : { 'refused' => progress.message }
rescue CSV::MalformedCSVError, RuntimeError => e
  { 'refused' => e.message }
end

def known(each) = each['previous_id'] || each['original_id']

importer, about, file = ARGV
require File.expand_path(importer)
given = JSON.parse(File.read(about, encoding: 'UTF-8'))
told = imported(Course.new(given), file)
if told['refused']
  puts JSON.generate(told)
  exit
end
scores = given['scores'].to_h { |student, assignment, mark| [[student, assignment], mark] }
told['students'].select { |each| known(each) }.each do |student|
  student['submissions'].each do |each|
    next if each['assignment_id'].to_i <= 0 || each['grade'] == each['original_grade']

    grade = each['grade'].to_s.upcase
    scores[[known(student), each['assignment_id']]] = grade == 'EX' ? 'EX' : grade.presence && Float(grade)
  end
end
asks = %w[students assignments].to_h do |kind|
  [kind, told[kind].reject { |each| known(each) }.map { |each| each['name'] || each['title'] }]
end
puts JSON.generate({ asks: asks, scores: scores.map { |(student, assignment), mark| [student, assignment, mark] } })
